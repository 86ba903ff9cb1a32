#include "viewer/territory_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <array>

namespace glisson {

namespace {

constexpr double kStepMm = 2;  ///< between the points of a tube: finer is not seen
constexpr int kTubeSides = 6;

struct DrawnSites {
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkTubeFilter> tubes;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkTextActor> label;  ///< flat: no tube hides it
};

/// Fewer points, no two in one place, both ends kept.
std::vector<Vec3> thinned(const std::vector<Vec3>& line) {
  std::vector<Vec3> kept;
  for (const Vec3& point : line) {
    if (kept.empty() || (point - kept.back()).norm() >= kStepMm) {
      kept.push_back(point);
    }
  }
  if (!kept.empty() && (line.back() - kept.back()).norm() > 0) {
    if (kept.size() > 1) {
      kept.back() = line.back();
    } else {
      kept.push_back(line.back());
    }
  }
  return kept;
}

void addTube(DrawnSites& drawn, vtkDoubleArray* radii, const DrawnBranch& branch) {
  const std::vector<Vec3> line = thinned(branch.lineMm);
  if (line.size() < 2) {
    return;  // a tube has a length
  }
  drawn.lines->GetLines()->InsertNextCell(static_cast<int>(line.size()));
  for (const Vec3& point : line) {
    drawn.lines->GetLines()->InsertCellPoint(drawn.lines->GetPoints()->InsertNextPoint(point.x(), point.y(), point.z()));
    radii->InsertNextValue(branch.radiusMm);
  }
}

/// Of all territories that have a name.
Vec3 middleOf(const std::vector<DrawnTerritory>& territories) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const DrawnTerritory& territory : territories) {
    for (const DrawnBranch& branch : territory.branches) {
      for (const Vec3& point : branch.lineMm) {
        sum += territory.name.empty() ? Vec3(Vec3::Zero()) : point;
        count += territory.name.empty() ? 0 : 1;
      }
    }
  }
  return sum / std::max(count, 1.0);
}

/// Where the branches are farthest from that middle: there names of several territories keep clear of each other.
Vec3 placeOfName(const DrawnTerritory& territory, const Vec3& middle) {
  Vec3 place = middle;
  for (const DrawnBranch& branch : territory.branches) {
    for (const Vec3& point : branch.lineMm) {
      if ((point - middle).squaredNorm() > (place - middle).squaredNorm()) {
        place = point;
      }
    }
  }
  return place;
}

void style(vtkTextProperty* text, const std::array<double, 3>& colour) {
  text->SetFontSize(13);
  text->SetColor(1, 1, 1);
  text->SetBackgroundColor(0.1, 0.11, 0.13);
  text->SetBackgroundOpacity(0.85);
  text->SetFrame(1);
  text->SetFrameWidth(2);
  text->SetFrameColor(colour[0], colour[1], colour[2]);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToBottom();
}

std::unique_ptr<DrawnSites> draw(const DrawnTerritory& territory, const Vec3& middle) {
  auto drawn = std::make_unique<DrawnSites>();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> radii;
  drawn->lines->SetPoints(points);
  drawn->lines->SetLines(lines);
  for (const DrawnBranch& branch : territory.branches) {
    addTube(*drawn, radii, branch);
  }
  drawn->lines->GetPointData()->SetScalars(radii);
  drawn->tubes->SetInputData(drawn->lines);
  drawn->tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  drawn->tubes->SetNumberOfSides(kTubeSides);
  drawn->tubes->CappingOn();
  drawn->mapper->SetInputConnection(drawn->tubes->GetOutputPort());
  drawn->mapper->ScalarVisibilityOff();
  drawn->actor->SetMapper(drawn->mapper);
  const std::array colour{territory.colour.r / 255.0, territory.colour.g / 255.0, territory.colour.b / 255.0};
  drawn->actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  drawn->actor->GetProperty()->LightingOff();  // the colour is the one in the list
  if (!territory.name.empty() && points->GetNumberOfPoints() > 0) {
    const Vec3 place = placeOfName(territory, middle);
    drawn->label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    drawn->label->GetPositionCoordinate()->SetValue(place.x(), place.y(), place.z());
    drawn->label->SetInput(territory.name.c_str());
    style(drawn->label->GetTextProperty(), colour);
  } else {
    drawn->label->SetVisibility(false);
  }
  return drawn;
}

}  // namespace

Rgb territoryColour(std::size_t place) {
  static constexpr std::array<Rgb, kTerritoryColours> kColours{
      {{80, 240, 255}, {240, 40, 120}, {255, 255, 0}, {80, 80, 255}, {40, 240, 80}, {200, 40, 255}, {0, 120, 120}, {80, 120, 0}}};
  return kColours[place % kColours.size()];
}

struct TerritoryActors::Impl {
  vtkRenderer* overlay = nullptr;
  std::vector<DrawnTerritory> territories;
  std::vector<std::unique_ptr<DrawnSites>> drawn;

  void clear() {
    for (const auto& each : drawn) {
      overlay->RemoveActor(each->actor);
      overlay->RemoveViewProp(each->label);
    }
    drawn.clear();
  }
};

TerritoryActors::TerritoryActors(vtkRenderer* overlay) : impl_(std::make_unique<Impl>()) { impl_->overlay = overlay; }

TerritoryActors::~TerritoryActors() { impl_->clear(); }

bool TerritoryActors::setTerritories(std::vector<DrawnTerritory> territories) {
  Impl& d = *impl_;
  if (territories == d.territories) {
    return false;
  }
  d.clear();
  d.territories = std::move(territories);
  const Vec3 middle = middleOf(d.territories);
  for (const DrawnTerritory& territory : d.territories) {
    d.drawn.push_back(draw(territory, middle));
    d.overlay->AddActor(d.drawn.back()->actor);
    d.overlay->AddViewProp(d.drawn.back()->label);
  }
  return true;
}

}  // namespace glisson
