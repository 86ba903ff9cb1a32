#include "viewer/section_actors.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkContourTriangulator.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <QPainter>
#include <algorithm>
#include <optional>

#include "viewer/colour.h"

namespace glisson {

namespace {

constexpr Colour kFill{0.86, 0.89, 0.93};
constexpr Colour kGrid{0.25, 0.28, 0.33};
constexpr Colour kOutline{1.0, 1.0, 1.0};
constexpr double kGridLiftMm = 0.2;  ///< the grid lies this far off the fill on both sides, else the two flicker
constexpr double kFillStepMm = 3;    ///< of a bent surface's triangles
constexpr double kFillOpacity = 0.6;
constexpr double kWeakOpacity = 0.3;

struct Drawable {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  void init(vtkRenderer* renderer, const Colour& colour) {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour.r, colour.g, colour.b);
    renderer->AddActor(actor);
  }
};

vtkIdType addPoint(vtkPoints* points, const Vec3& at) { return points->InsertNextPoint(at.x(), at.y(), at.z()); }

void addLoop(vtkPoints* points, vtkCellArray* lines, const Loop& loop) {
  lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
  const vtkIdType first = points->GetNumberOfPoints();
  for (const Vec3& point : loop) {
    lines->InsertCellPoint(addPoint(points, point));
  }
  lines->InsertCellPoint(first);
}

bool isEmpty(vtkPolyData* data) { return data->GetPoints() == nullptr || data->GetNumberOfCells() == 0; }

/// The part where `value` of a point is above 0, or below it; exact where it is linear.
template <typename Value>
vtkSmartPointer<vtkPolyData> clipped(vtkPolyData* data, bool above, const Value& value) {
  vtkNew<vtkDoubleArray> values;
  values->SetName("above");
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n) {
    Vec3 at;
    data->GetPoint(n, at.data());
    values->InsertNextValue(value(at));
  }
  vtkNew<vtkPolyData> marked;
  marked->ShallowCopy(data);
  marked->GetPointData()->SetScalars(values);
  vtkNew<vtkClipPolyData> clipper;
  clipper->SetInputData(marked);
  clipper->SetValue(0);
  clipper->SetInsideOut(above ? 0 : 1);
  clipper->Update();
  vtkSmartPointer<vtkPolyData> kept = clipper->GetOutput();
  kept->GetPointData()->SetScalars(nullptr);
  return kept;
}

/// Keeps what lies above the surface.
void clip(vtkPolyData* data, const BentSurface& surface) {
  if (!isEmpty(data)) {
    data->ShallowCopy(clipped(data, true, [&](const Vec3& at) { return surface.above(at); }));
    data->Modified();
  }
}

/// Keeps what is not inside another resection: outside its first plane, or inside that and outside the second, and so on.
void clipAway(vtkPolyData* data, const std::vector<ResectionPlane>& resection, const Vec3& before) {
  if (isEmpty(data)) {
    return;
  }
  vtkNew<vtkAppendPolyData> kept;
  bool any = false;
  vtkSmartPointer<vtkPolyData> rest = data;
  for (const ResectionPlane& bound : resection) {
    const std::optional<BentSurface> bent = bound.bend ? std::optional(BentSurface(bound)) : std::nullopt;
    const auto above = [&](const Vec3& at) {
      const Vec3 there = at + before;
      return bent ? bent->above(there) : bound.normal.dot(there - bound.origin);
    };
    const vtkSmartPointer<vtkPolyData> outside = clipped(rest, false, above);
    if (!isEmpty(outside)) {
      kept->AddInputData(outside);
      any = true;
    }
    rest = clipped(rest, true, above);
    if (isEmpty(rest)) {
      break;
    }
  }
  if (any) {
    kept->Update();
    data->ShallowCopy(kept->GetOutput());
  } else {
    data->Initialize();
  }
  data->Modified();
}

/// RGBA, not premultiplied, from the bottom row up, as VTK wants it: the picture's row 0 is the grid's, so nothing is turned over.
vtkSmartPointer<vtkImageData> toImageData(const QImage& picture) {
  const QImage plain = picture.convertToFormat(QImage::Format_RGBA8888);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(plain.width(), plain.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
  const auto bytes = static_cast<std::size_t>(plain.width()) * 4;
  for (int row = 0; row < plain.height(); ++row, out += bytes) {
    std::copy_n(plain.constScanLine(row), bytes, out);
  }
  return image;
}

}  // namespace

struct SectionActors::Impl {
  vtkRenderer* model = nullptr;
  vtkRenderer* overlay = nullptr;
  Drawable fill, colours, grid, outline, vessels;
  vtkNew<vtkTexture> texture;
  double opacity = 1;  ///< of the fill
  std::vector<Drawable*> all{&fill, &colours, &grid, &outline, &vessels};
};

SectionActors::SectionActors(vtkRenderer* model, vtkRenderer* overlay, bool strong) : impl_(std::make_unique<Impl>()) {
  Impl& d = *impl_;
  d.model = model;
  d.overlay = overlay;
  d.fill.init(model, kFill);
  d.opacity = strong ? kFillOpacity : kWeakOpacity;
  d.fill.actor->GetProperty()->SetOpacity(d.opacity);
  d.colours.init(model, kOutline);
  d.colours.actor->SetTexture(d.texture);
  d.colours.actor->ForceTranslucentOn();
  d.texture->InterpolateOn();
  d.grid.init(model, kGrid);
  d.outline.init(overlay, kOutline);
  d.outline.actor->GetProperty()->SetLineWidth(strong ? 2 : 1);
  d.vessels.init(overlay, kOutline);
  d.vessels.mapper->ScalarVisibilityOn();
  d.vessels.actor->GetProperty()->SetLineWidth(2);
}

SectionActors::~SectionActors() {
  for (Drawable* part : {&impl_->fill, &impl_->colours, &impl_->grid}) {
    impl_->model->RemoveActor(part->actor);
  }
  for (Drawable* part : {&impl_->outline, &impl_->vessels}) {
    impl_->overlay->RemoveActor(part->actor);
  }
}

void SectionActors::setVisible(bool visible) {
  for (Drawable* part : impl_->all) {
    part->actor->SetVisibility(visible);
  }
}

void SectionActors::setSection(const ResectionMap& map, const QImage& margins) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Loop& loop : map.outline) {
    addLoop(points, lines, loop);
  }
  impl_->outline.data->SetPoints(points);
  impl_->outline.data->SetLines(lines);
  impl_->outline.data->Modified();

  setFill(map);
  setGrid(map);

  vtkNew<vtkPoints> vesselPoints;
  vtkNew<vtkCellArray> vesselLines;
  vtkNew<vtkUnsignedCharArray> vesselColours;
  vesselColours->SetNumberOfComponents(3);
  for (const auto& [colour, loop] : map.vessels) {
    addLoop(vesselPoints, vesselLines, loop);
    vesselColours->InsertNextTuple3(colour.r, colour.g, colour.b);
  }
  impl_->vessels.data->SetPoints(vesselPoints);
  impl_->vessels.data->SetLines(vesselLines);
  impl_->vessels.data->GetCellData()->SetScalars(vesselColours);
  impl_->vessels.data->Modified();

  setMargins(map, margins);
  for (Drawable* part : impl_->all) {
    part->mapper->RemoveAllClippingPlanes();
    for (const std::vector<ResectionPlane>& other : map.others) {
      clipAway(part->data, other, -kBeforeMm * map.plane.normal);
    }
    for (const ResectionPlane& bound : map.within) {
      if (bound.bend) {
        clip(part->data, BentSurface(bound));
        continue;
      }
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(bound.origin.data());
      plane->SetNormal(bound.normal.data());
      part->mapper->AddClippingPlane(plane);
    }
  }
}

void SectionActors::setFill(const ResectionMap& map) {
  vtkPolyData* fill = impl_->fill.data;
  const SurfaceMesh curved = map.plane.bend ? filled(map.outline, BentSurface(map.plane), kFillStepMm) : SurfaceMesh();
  if (!curved.empty()) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const Vec3& v : curved.vertices) {
      addPoint(points, v);
    }
    for (const Triangle& t : curved.triangles) {
      cells->InsertNextCell({t[0], t[1], t[2]});
    }
    fill->SetPoints(points);
    fill->SetPolys(cells);
  } else {
    vtkNew<vtkContourTriangulator> triangulator;
    triangulator->TriangulationErrorDisplayOff();
    triangulator->SetInputData(impl_->outline.data);
    triangulator->Update();
    fill->SetPoints(triangulator->GetOutput()->GetPoints());
    fill->SetPolys(triangulator->GetOutput()->GetPolys());
  }
  fill->Modified();
}

void SectionActors::setGrid(const ResectionMap& map) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto lines = map.plane.bend ? gridLines(map.outline, BentSurface(map.plane), kGridMm)
                                    : gridLines(map.outline, static_cast<const HalfSpace&>(map.plane), kGridMm);
  for (const auto& [from, to] : lines) {
    for (const double side : {-kGridLiftMm, kGridLiftMm}) {
      const Vec3 lift = side * map.plane.normal;
      cells->InsertNextCell(2);
      cells->InsertCellPoint(addPoint(points, from + lift));
      cells->InsertCellPoint(addPoint(points, to + lift));
    }
  }
  impl_->grid.data->SetPoints(points);
  impl_->grid.data->SetLines(cells);
  impl_->grid.data->Modified();
}

void SectionActors::setMargins(const ResectionMap& map, const QImage& margins) {
  Impl& d = *impl_;
  d.colours.data->SetPolys(nullptr);
  if (margins.isNull() || !map.margins || d.fill.data->GetPoints() == nullptr) {
    d.colours.data->Modified();
    return;
  }
  // In place of the plain fill, the picture over the fill's colour: a texture's point is where the fill's point lies in the
  // picture's rectangle.
  const PlaneGrid& grid = map.margins->grid;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkPoints* points = d.fill.data->GetPoints();
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n) {
    Vec3 at;
    points->GetPoint(n, at.data());
    const Vec3 from = at - grid.origin;
    places->InsertNextTuple2(from.dot(grid.u) / (grid.stepMm * (grid.columns - 1)),
                             from.dot(grid.v) / (grid.stepMm * (grid.rows - 1)));
  }
  d.colours.data->SetPoints(points);
  d.colours.data->SetPolys(d.fill.data->GetPolys());
  d.colours.data->GetPointData()->SetTCoords(places);
  d.colours.data->Modified();
  d.fill.data->SetPolys(nullptr);  // two sheets in one place would hide each other
  d.fill.data->Modified();
  QImage picture(margins.size(), QImage::Format_ARGB32_Premultiplied);
  picture.fill(QColor::fromRgbF(static_cast<float>(kFill.r), static_cast<float>(kFill.g), static_cast<float>(kFill.b),
                                static_cast<float>(d.opacity)));
  QPainter(&picture).drawImage(0, 0, margins);
  d.texture->SetInputData(toImageData(picture));
}

}  // namespace glisson
