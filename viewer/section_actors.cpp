#include "viewer/section_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace glisson {

namespace {

struct Colour {
  double r, g, b;
};
constexpr Colour kFill{0.86, 0.89, 0.93};
constexpr Colour kGrid{0.25, 0.28, 0.33};
constexpr Colour kOutline{1.0, 1.0, 1.0};
constexpr double kGridLiftMm = 0.2;  ///< the grid lies this far off the fill on both sides, else the two flicker
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

}  // namespace

struct SectionActors::Impl {
  vtkRenderer* model = nullptr;
  vtkRenderer* overlay = nullptr;
  Drawable fill, grid, outline;
};

SectionActors::SectionActors(vtkRenderer* model, vtkRenderer* overlay, bool strong) : impl_(std::make_unique<Impl>()) {
  Impl& d = *impl_;
  d.model = model;
  d.overlay = overlay;
  d.fill.init(model, kFill);
  d.fill.actor->GetProperty()->SetOpacity(strong ? kFillOpacity : kWeakOpacity);
  d.grid.init(model, kGrid);
  d.grid.actor->SetVisibility(strong);
  d.outline.init(overlay, kOutline);
  d.outline.actor->GetProperty()->SetLineWidth(strong ? 2 : 1);
}

SectionActors::~SectionActors() {
  impl_->model->RemoveActor(impl_->fill.actor);
  impl_->model->RemoveActor(impl_->grid.actor);
  impl_->overlay->RemoveActor(impl_->outline.actor);
}

void SectionActors::setVisible(bool visible) {
  for (Drawable* part : {&impl_->fill, &impl_->grid, &impl_->outline}) {
    part->actor->SetVisibility(visible);
  }
}

void SectionActors::setSection(const HalfSpace& plane, const std::vector<Loop>& loops, const std::vector<HalfSpace>& within) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Loop& loop : loops) {
    lines->InsertNextCell(static_cast<int>(loop.size()) + 1);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Vec3& point : loop) {
      lines->InsertCellPoint(addPoint(points, point));
    }
    lines->InsertCellPoint(first);
  }
  impl_->outline.data->SetPoints(points);
  impl_->outline.data->SetLines(lines);
  impl_->outline.data->Modified();

  vtkNew<vtkContourTriangulator> triangulator;
  triangulator->TriangulationErrorDisplayOff();
  triangulator->SetInputData(impl_->outline.data);
  triangulator->Update();
  impl_->fill.data->SetPoints(triangulator->GetOutput()->GetPoints());
  impl_->fill.data->SetPolys(triangulator->GetOutput()->GetPolys());
  impl_->fill.data->Modified();

  vtkNew<vtkPoints> gridPoints;
  vtkNew<vtkCellArray> gridCells;
  for (const auto& [from, to] : gridLines(loops, plane, kGridMm)) {
    for (const double side : {-kGridLiftMm, kGridLiftMm}) {
      const Vec3 lift = side * plane.normal;
      gridCells->InsertNextCell(2);
      gridCells->InsertCellPoint(addPoint(gridPoints, from + lift));
      gridCells->InsertCellPoint(addPoint(gridPoints, to + lift));
    }
  }
  impl_->grid.data->SetPoints(gridPoints);
  impl_->grid.data->SetLines(gridCells);
  impl_->grid.data->Modified();

  for (Drawable* part : {&impl_->fill, &impl_->grid, &impl_->outline}) {
    part->mapper->RemoveAllClippingPlanes();
    for (const HalfSpace& bound : within) {
      vtkNew<vtkPlane> clip;
      clip->SetOrigin(bound.origin.data());
      clip->SetNormal(bound.normal.data());
      part->mapper->AddClippingPlane(clip);
    }
  }
}

}  // namespace glisson
