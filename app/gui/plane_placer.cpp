#include "app/gui/plane_placer.h"

#include <Eigen/Geometry>
#include <QStringList>

#include "app/gui/number_text.h"
#include "app/gui/place_menu.h"
#include "app/gui/sentences.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

PlanePlacer::PlanePlacer(JobRunner& jobs, Document& document, ViewArea& views, QWidget* parent)
    : QObject(parent), jobs_(jobs), document_(document), views_(views), menu_(new PlaceMenu(document, parent)) {
  connect(menu_, &PlaceMenu::pickRequested, this, &PlanePlacer::startPick);
  connect(menu_, &PlaceMenu::sliceRequested, this, &PlanePlacer::placeAlongSlice);
  connect(menu_, &PlaceMenu::tumourRequested, this, [this](const QString& id) { placeAroundTumour(id.toStdString()); });
  connect(&views_.modelView(), &ModelView::picked, this, &PlanePlacer::onPicked);
  connect(&views_.modelView(), &ModelView::pickCancelled, this, [this] { emit hint({}); });
  connect(&document_, &Document::caseChanged, &views_.modelView(), &ModelView::cancelPick);
}

void PlanePlacer::place(const std::function<HalfSpace()>& make) {
  try {
    document_.placePlane(make());
    emit placed();
  } catch (const Error& error) {
    emit refused(messageOf(error));
  }
}

void PlanePlacer::placeAsSeen() {
  const std::optional<Vec3> centre = document_.liverCentre();
  if (!document_.isOpen() || !centre) {
    document_.prepareVolumes();
    emit refused(QStringLiteral("The plane can be placed as soon as the liver's volumes are computed."));
    return;
  }
  const ModelView& view = views_.modelView();
  place([&] { return planeFromCamera(*centre, view.viewDirection(), view.viewUp()); });
}

void PlanePlacer::addAsSeen(bool ownResection) {
  const std::optional<Vec3> centre = document_.liverCentre();
  if (!centre || !document_.plane()) {
    return;  // the controls are disabled then
  }
  try {
    const ModelView& view = views_.modelView();
    const HalfSpace plane = planeFromCamera(*centre, view.viewDirection(), view.viewUp());
    if (ownResection) {
      document_.edit(AddResection{{.name = {}, .planes = {plane}}});
    } else {
      document_.edit(AddPlane{document_.chosen().resection, plane});
    }
    emit placed();
  } catch (const Error& error) {
    emit refused(messageOf(error));
  }
}

void PlanePlacer::moveBy(double mm) {
  document_.cancelDrag();  // the step begins where the plane is back
  if (const std::optional<HalfSpace> plane = document_.plane()) {
    document_.movePlane(movedAlongNormal(*plane, mm));
  }
}

void PlanePlacer::tilt(double aboutUp, double aboutRight) {
  document_.cancelDrag();
  const std::optional<HalfSpace> plane = document_.plane();
  if (!plane) {
    return;
  }
  const ModelView& view = views_.modelView();
  const Vec3 right = view.viewDirection().cross(view.viewUp()).normalized();
  HalfSpace tilted = *plane;
  if (aboutUp != 0) {
    tilted = turned(tilted, view.viewUp(), aboutUp);
  }
  if (aboutRight != 0) {
    tilted = turned(tilted, right, aboutRight);
  }
  document_.movePlane(tilted);
}

void PlanePlacer::startPick(PickKind kind) {
  views_.modelView().startPick(kind);
  switch (kind) {
    case PickKind::Point:
      return emit hint(tr("Click a point of the model in the 3D view. Escape ends."));
    case PickKind::ThreePoints:
      return emit hint(tr("Click three points of the model in the 3D view; it can be turned in between. Escape ends."));
    case PickKind::Branch:
    case PickKind::TwoPoints:
      return;  // no planes
    case PickKind::Line:
      return emit hint(tr("Draw a line across the liver in the 3D view: what lies to its right is resected. Escape ends."));
  }
}

void PlanePlacer::onPicked(const Pick& pick) {
  if (pick.kind == PickKind::TwoPoints || pick.kind == PickKind::Branch) {
    return;
  }
  emit hint({});
  place([&] {
    switch (pick.kind) {
      case PickKind::Point:
        // From the eye to the point: else the plane is not seen edge-on there.
        return planeFromCamera(pick.points[0], (pick.points[0] - pick.camera.position).normalized(), pick.camera.up);
      case PickKind::ThreePoints:
        return planeThroughPoints(pick.points[0], pick.points[1], pick.points[2]);
      case PickKind::Branch:
      case PickKind::TwoPoints:
      case PickKind::Line:
        break;
    }
    HalfSpace plane = planeOfLineFromEye(pick.points[0], pick.points[1], pick.camera.position);
    if (const std::optional<Vec3> centre = document_.liverCentre()) {
      plane.origin = *centre - plane.normal.dot(*centre - plane.origin) * plane.normal;  // in the liver, not before the eye
    }
    return plane;
  });
}

void PlanePlacer::placeAlongSlice(SlicePlane slice) {
  if (document_.isOpen()) {
    place([&] { return planeParallelToSlice(document_.content().liver->geometry, slice, views_.crosshair()); });
  }
}

void PlanePlacer::placeAroundTumour(const std::string& id) {
  JobRequest request{.key = "marginPlane", .title = tr("Plane around a tumour")};
  request.fail = [this](const std::exception& error) { emit refused(messageOf(error)); };
  submitFor<MarginProposal>(
      jobs_, std::move(request),
      [content = document_.content(), id, margin = document_.plan().safetyMarginMm](const ExecutionContext& context) {
        return proposeMarginPlane(content, id, margin, context);
      },
      [this, code = document_.content().code, asked = document_.plan()](const MarginProposal& proposal) {
        if (document_.content().code == code) {
          onProposed(proposal, asked);
        }
      });
}

void PlanePlacer::onProposed(const MarginProposal& proposal, const ResectionPlan& asked) {
  const ResectionPlan& plan = document_.plan();
  if (plan != asked) {
    emit refused(QString::fromStdString("The plan has changed while the plane around " + proposal.tumourName +
                                        " was sought, so it is not placed; ask for it again."));
    return;
  }
  if (!proposal.plane) {
    emit refused(QString::fromStdString(proposal.reason));
    return;
  }
  const std::size_t resection = document_.chosen().resection;
  if (resection < plan.resections.size() && plan.resections[resection].planes.size() > 1) {
    document_.edit(AddResection{{.name = {}, .planes = {*proposal.plane}}});  // with other planes it would not remove the tumour
    emit placed();
  } else {
    place([&] { return *proposal.plane; });
  }
  std::string text = "The plane around " + proposal.tumourName + " keeps at least " + formatNumber(proposal.marginAtLeastMm, 1) +
                     " mm, takes by itself " + formatNumber(proposal.resectedFunctionalMl, 0) +
                     " mL of functional liver and crosses " + std::to_string(proposal.vessels.size()) +
                     " vessels of 3 mm and more.";
  for (const VesselCrossing& vessel : proposal.vessels) {
    text += (vessel.runsAlong ? " It cuts along " : " It crosses ") + vessel.name + ", " + formatNumber(vessel.diameterMm, 1) +
            " mm wide.";
  }
  emit refused(QString::fromStdString(text + " " + proposal.notice));
}

}  // namespace glisson
