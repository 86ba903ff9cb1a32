#include "viewer/model_view_impl.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace glisson {

namespace {

constexpr std::size_t kUploadTriangles = 60000;  ///< new ones of one resting frame, unless a single mesh is larger
constexpr double kCoarseStepMm = 3;              ///< of the margin colours while the plane moves
constexpr double kFineStepMm = 1.5;
constexpr int kCoarsePixels = 3;
constexpr int kFinePixels = 4;

}  // namespace

bool ModelView::Impl::showStructures(const std::vector<std::shared_ptr<const DisplayMesh>>& ready) {
  std::map<std::string, std::unique_ptr<StructureActors>> shown;
  bool anyKept = false;
  parenchyma.clear();
  static const std::vector<Structure> kNone;
  for (const Structure& structure : model ? model->structures : kNone) {
    if (!structure.reconstruction || structure.reconstruction->mesh.empty()) {
      continue;
    }
    const bool isParenchyma = structure.kind == StructureKind::Liver;
    std::unique_ptr<StructureActors>& actors = shown[structure.id];
    const auto old = structures.find(structure.id);
    if (old != structures.end() && old->second->source() == structure.reconstruction.get()) {
      actors = std::move(old->second);
      structures.erase(old);
      anyKept = true;
    } else {
      const auto made = std::ranges::find_if(ready, [&](const auto& mesh) { return mesh->source == structure.reconstruction; });
      actors = std::make_unique<StructureActors>(
          scene.renderer, made != ready.end() ? *made : makeDisplayMesh(structure.reconstruction), isParenchyma);
      scene.budget.forget();
    }
    actors->setLook(structure.colour, structure.opacity, structure.visible);
    actors->setPlan(plan);
    if (isParenchyma) {
      parenchyma = structure.id;
    }
  }
  structures = std::move(shown);
  sectionStale = true;
  return !anyKept;
}

void ModelView::Impl::showPlan() {
  sections.clear();
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    for (std::size_t p = 0; p < plan.resections[r].planes.size(); ++p) {
      sections.push_back(
          std::make_unique<SectionActors>(scene.renderer, scene.overlay, r == choice.resection && p == choice.plane));
    }
  }
}

ResectionMap ModelView::Impl::mapOf(std::size_t resection, std::size_t index, bool coarse) const {
  ResectionMap map;
  const std::vector<ResectionPlane>& planes = plan.resections[resection].planes;
  map.plane = planes[index];
  map.safetyMarginMm = plan.safetyMarginMm;
  map.within = planes;
  map.within.erase(map.within.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    if (r != resection && !plan.resections[r].planes.empty()) {
      map.others.push_back(plan.resections[r].planes);
    }
  }
  const auto loopsOf = [&](const StructureActors& actors) {
    return sectionLoops(coarse ? actors.coarseMesh() : actors.mesh(), map.plane);
  };
  if (const auto liver = structures.find(parenchyma); liver != structures.end()) {
    map.outline = loopsOf(*liver->second);
  }
  if (map.outline.empty()) {
    return map;
  }
  if (tumours != nullptr && !tumours->empty()) {
    const std::optional<BentSurface> bent = map.plane.bend ? std::optional(BentSurface(map.plane)) : std::nullopt;
    map.margins = marginMap(*tumours, gridOver(map.outline, map.plane, coarse ? kCoarseStepMm : kFineStepMm),
                            std::max(kFarthestMm, plan.safetyMarginMm + kIsoLineMm), bent ? &*bent : nullptr);
  }
  for (const Structure& structure : model->structures) {
    const auto actors = isVessel(structure.kind) ? structures.find(structure.id) : structures.end();
    if (actors == structures.end() || !actors->second->visible()) {
      continue;
    }
    for (Loop& loop : loopsOf(*actors->second)) {
      if (isInside(map.outline, map.plane, loop.front())) {
        map.vessels.emplace_back(structure.colour, std::move(loop));
      }
    }
  }
  return map;
}

void ModelView::Impl::placeResectogram() {
  constexpr int kGap = 6;
  const QSize size = resectogram->sizeHint().boundedTo(QSize(view->width() / 2, view->height() / 2));
  resectogram->setGeometry(view->width() - size.width() - kGap, view->height() - size.height() - kGap, size.width(), size.height());
}

/// The sections through the parenchyma; the coarse stand-in while the plane moves. False where they were there.
bool ModelView::Impl::updateSection(bool coarse) {
  if (!plane || !(sectionStale || (sectionIsCoarse && !coarse))) {
    return false;
  }
  section.clear();
  std::size_t drawn = 0;
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    const std::vector<ResectionPlane>& planes = plan.resections[r].planes;
    for (std::size_t p = 0; p < planes.size(); ++p, ++drawn) {
      ResectionMap map = mapOf(r, p, coarse);
      const QImage margins =
          map.margins ? marginPicture(*map.margins, map.safetyMarginMm, coarse ? kCoarsePixels : kFinePixels) : QImage();
      sections[drawn]->setSection(map, margins);
      if (r == choice.resection && p == choice.plane) {
        section = map.outline;
        resectogram->setMap(std::move(map), margins);
      }
    }
  }
  sectionStale = false;
  sectionIsCoarse = coarse;
  anchor = drag ? drag->anchorFor(*plane) : anchorOf(*plane, section);
  return true;
}

FramePlan ModelView::Impl::planFrame(FrameQuality quality) {
  TriangleCounts triangles;
  bool anyTranslucent = plane.has_value();
  for (const auto& [id, actors] : structures) {
    triangles.reduced += actors->triangles(Detail::Reduced);
    triangles.full += actors->triangles(Detail::Full);
    anyTranslucent = anyTranslucent || actors->translucent();
  }
  FramePlan frame = scene.budget.plan(quality, triangles, anyTranslucent);
  if (fullDetail) {
    frame.detail = Detail::Full;
    frame.scale = 1;
    frame.smoothEdges = quality != FrameQuality::Moving;
  }
  std::size_t uploading = 0;
  for (const auto& [id, actors] : structures) {
    Detail detail = frame.detail;
    const std::size_t needed = actors->triangles(detail);
    if ((quality == FrameQuality::Resting || quality == FrameQuality::Report) && needed > 0 && !actors->uploaded(detail)) {
      frame.uploads = true;
      if (uploading > 0 && uploading + needed > kUploadTriangles) {
        frame.moreToUpload = true;
        detail = actors->uploaded(Detail::Reduced) ? Detail::Reduced : Detail::Coarse;
      } else {
        uploading += needed;
      }
    }
    actors->setDetail(detail);
  }
  if (quality == FrameQuality::Report && frame.moreToUpload) {
    frame.peels = frame.smoothEdges = false;  // nobody sees it
  }
  return frame;
}

void ModelView::Impl::prepareFrame(FrameQuality quality) {
  scene.use(planFrame(quality));
  cube.drawInTile(scene.tile);
  planeActors.setVisible(plane.has_value() && handlesShown);
  if (plane) {
    updateSection(quality == FrameQuality::Moving);
    if (handlesShown) {
      planeActors.placeHandles(*plane, layout(), drag ? std::optional(drag->handle()) : hovered, !canBend());
    }
    planeActors.placeControlPoints(canBend() ? &*plane : nullptr, highlightedPoints(), layout().mmPerPixel);
  } else {
    planeActors.placeControlPoints(nullptr, {}, 1);
  }
  scene.fitClippingRange();
}

void ModelView::Impl::lookFrom(const Vec3& direction, const Vec3& up) {
  placedDirection = direction;
  placedUp = up;
  Eigen::AlignedBox3d box(Vec3(-100, -100, -100), Vec3(100, 100, 100));
  if (!structures.empty()) {
    box.setEmpty();
  }
  for (const auto& [id, actors] : structures) {
    const Bounds bounds = boundsOf(actors->mesh());
    box.extend(bounds.low);
    box.extend(bounds.high);
  }
  scene.lookAt(box, direction, up, static_cast<double>(view->width()) / std::max(1, view->height()));
  view->requestRender();
}

void ModelView::Impl::fitAgain() {
  if (!scene.cameraByHand) {
    lookFrom(placedDirection, placedUp);
  }
}

std::optional<PlaneHandle> ModelView::Impl::planeHandleAt(const Pixel& mouse) const {
  const std::optional<PlaneHandle> handle = handleAt(*view->handles(), view->camera(), mouse);
  // While the plane is bent it is not tilted: those handles lie among the control points.
  return canBend() && handle && isTilt(*handle) ? std::nullopt : handle;
}

std::array<bool, 16> ModelView::Impl::highlightedPoints() const {
  std::array<bool, 16> members{};
  const std::optional<std::size_t> point = bendDrag ? std::optional(bendDrag->point()) : (hoveredPoint ? hoveredPoint : keyedPoint);
  if (point && (bendDrag ? bendDrag->group() : bendGroup)) {
    members = groupOf(*point);
  } else if (point) {
    members[*point] = true;
  }
  return members;
}

void ModelView::Impl::endDrag(const ResectionPlane& at) {
  drag.reset();
  bendDrag.reset();
  sectionStale = true;
  emit view->planeDragFinished(at);
  view->requestRender();
}

}  // namespace glisson
