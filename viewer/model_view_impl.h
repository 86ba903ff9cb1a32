#pragma once
// Purpose: what ModelView is made of. Private to viewer/: only .cpp files include it.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/bend_handles.h"
#include "viewer/measure_actors.h"
#include "viewer/model_view.h"
#include "viewer/orientation_cube.h"
#include "viewer/pick_overlay.h"
#include "viewer/plane_actors.h"
#include "viewer/resectogram.h"
#include "viewer/section_actors.h"
#include "viewer/structure_actors.h"
#include "viewer/territory_actors.h"
#include "viewer/vtk_scene.h"

namespace glisson {

struct ModelView::Impl {
  explicit Impl(ModelView* owner)
      : view(owner),
        scene(owner->scene()),
        planeActors(scene.overlay),
        measureActors(scene.overlay),
        territoryActors(scene.overlay),
        cube(scene.interactor, scene.renderer) {}

  ModelView* view;
  Scene& scene;
  std::shared_ptr<const LiverModel> model;
  std::map<std::string, std::unique_ptr<StructureActors>> structures;
  std::string parenchyma;  ///< id of the structure the plane cuts; empty where there is none yet
  ResectionPlan plan;
  PlaneChoice choice;
  std::optional<ResectionPlane> plane;  ///< the one worked on, with handles; it stands in `plan` too
  PlaneActors planeActors;
  MeasureActors measureActors;
  TerritoryActors territoryActors;
  std::vector<std::unique_ptr<SectionActors>> sections;  ///< one for each plane of the plan, in its order
  OrientationCube cube;
  std::vector<Loop> section;
  bool sectionStale = true;
  bool sectionIsCoarse = false;
  bool handlesShown = true;
  bool fullDetail = false;  ///< of moving frames, too
  bool bending = false;     ///< control points are shown where the plane is bent
  bool bendGroup = false;   ///< they move with their group
  Vec3 anchor = Vec3::Zero();
  std::optional<PlaneDrag> drag;
  double spun = 0;      ///< of a flat plane, radians: how far its handles are turned within it
  double spunFrom = 0;  ///< the same when the drag began
  std::optional<BendDrag> bendDrag;
  std::optional<std::size_t> hoveredPoint;
  std::optional<std::size_t> keyedPoint;  ///< the last one chosen or dragged: the one that keys move
  std::optional<PlaneHandle> hovered;
  std::optional<PickTool> pick;
  std::shared_ptr<const TumourDistance> tumours;
  Resectogram* resectogram = nullptr;  ///< a child of the view
  PickOverlay* pickOverlay = nullptr;  ///< a child of the view
  Vec3 placedDirection = Vec3::UnitY();
  Vec3 placedUp = Vec3::UnitZ();

  /// Shows the structures of `model`; true where none of those shown before is left (a new patient).
  bool showStructures(const std::vector<std::shared_ptr<const DisplayMesh>>& ready);
  bool updateSection(bool coarse);
  [[nodiscard]] ResectionMap mapOf(std::size_t resection, std::size_t plane, bool coarse) const;
  void placeResectogram();
  /// Makes the drawing of each plane anew where their number or the choice has changed.
  void showPlan();
  void prepareFrame(FrameQuality quality);
  /// Plans the frame and gives every structure its mesh. Resting frames upload only some new ones at a time: the window answers in
  /// between.
  [[nodiscard]] FramePlan planFrame(FrameQuality quality);
  /// Places the camera so that the whole model is seen along `direction`.
  void lookFrom(const Vec3& direction, const Vec3& up);
  /// Places it again along the last direction, unless the user has moved it since.
  void fitAgain();
  [[nodiscard]] HandleLayout layout() const { return layoutHandles(*plane, anchor, section, view->camera(), spun); }
  [[nodiscard]] bool canBend() const { return bending && handlesShown && plane && plane->bend; }
  [[nodiscard]] std::optional<PlaneHandle> planeHandleAt(const Pixel& mouse) const;
  [[nodiscard]] std::array<bool, 16> highlightedPoints() const;
  void endDrag(const ResectionPlane& at);
};

}  // namespace glisson
