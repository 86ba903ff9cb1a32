#pragma once
// Purpose: the 3D view: the combined model, the resection plane with its handles, orientation cube and letters. Frame: mm LPS.
// Mouse: left rotates, middle pans, right or wheel zooms; 1/3/7 anterior/left/superior. Handles of the plane take the left button
// first; Escape during a drag takes it back. Keys for the plane: PageUp/PageDown or +/- move it 1 mm along its normal (Shift 0.1
// mm, Ctrl 5 mm), Ctrl+arrows tilt it by 1 degree about its centre, Home and End spin it about its normal (with Shift 5 degrees).
// While a bent plane's control points are
// shown they take the left button (with Shift: their group moves), and the keys along the normal move the one chosen last.

#include <memory>
#include <optional>

#include "planning/case/liver_model.h"
#include "planning/resection/resection_plan.h"
#include "planning/volumetry/tumour_distance.h"
#include "viewer/display_mesh.h"
#include "viewer/drawn_territory.h"
#include "viewer/pick_tool.h"
#include "viewer/view_camera.h"
#include "viewer/vtk_widget.h"

namespace glisson {

struct HandleLayout;

/// Which plane of a plan has the handles, by its places in the lists.
struct PlaneChoice {
  std::size_t resection = 0;
  std::size_t plane = 0;
  bool operator==(const PlaneChoice&) const = default;
};

class ModelView : public VtkWidget {
  Q_OBJECT
 public:
  explicit ModelView(QWidget* parent = nullptr);
  ~ModelView() override;

  /// Shows this snapshot; structures without a mesh are left out, unchanged meshes are not uploaded again. Null clears the view.
  /// The camera is placed (from anterior) when the first structure of a new patient appears, and makes room for the next ones
  /// until the user moves it. Surfaces that are not among `ready` are made ready here, which keeps the caller waiting.
  void setModel(std::shared_ptr<const LiverModel> model, const std::vector<std::shared_ptr<const DisplayMesh>>& ready = {});
  /// The plan's planes, drawn only inside the parenchyma's mesh and where they bound their resection, the two sides told apart
  /// (what is resected is tinted and labelled); the chosen plane has grid and handles, which nothing hides. The plan's measured
  /// distances are drawn, too. Emits no signal.
  void setPlan(ResectionPlan plan, const PlaneChoice& choice = {});
  /// Without handles planes are only looked at. With them is the default.
  void setHandlesShown(bool shown);
  /// Lets go of the handle that is dragged; the plane stays where setPlan() puts it, and planeDragFinished() does not come.
  void cancelDrag();
  /// Draws every frame with the full meshes in full resolution, whatever it costs, so that all surfaces are seen alike; where
  /// OpenGL runs in software large ones then move in jumps. Not so is the default.
  void setFullDetail(bool full);
  /// Puts the chosen plane there, bent or not; makes a plan of one plane where there is none; nothing: an empty plan.
  void setPlane(const std::optional<ResectionPlane>& plane);
  [[nodiscard]] std::optional<ResectionPlane> plane() const;
  /// Shows the control points of the chosen plane where it is bent; `group`: they move with their group. Not shown is the default.
  void setBending(bool shown, bool group);
  /// Turns the chosen plane about its normal, right-handed: a bent one in one step; of a flat one, which stays the same, the
  /// handles.
  void spinPlane(double radians);
  /// The control point, 0..15, that is highlighted and that keys move. Emits no signal.
  void chooseControlPoint(int point);

  /// Whether the flat map of the cut is unfolded, in the corner; it is by default. Where the user folds it, mapShownChanged()
  /// tells.
  void setMapShown(bool shown);
  [[nodiscard]] bool mapShown() const;
  /// What the resection surface is coloured by; null: it stays plain.
  void setTumours(std::shared_ptr<const TumourDistance> tumours);
  /// The portal branches of territories, in their colours; nothing hides them. None is the default.
  void setTerritories(std::vector<DrawnTerritory> territories);
  /// The shortest way from the tumour that decides to the resection surface; red where it is too short.
  void setMarginLine(const std::optional<std::pair<Vec3, Vec3>>& line, bool tooShort);

  enum class StandardView { Anterior, Posterior, Left, Right, Superior, Inferior };
  void setStandardView(StandardView view);
  /// Unit vectors, mm LPS: where the camera looks and its up. For planeFromCamera().
  [[nodiscard]] Vec3 viewDirection() const;
  [[nodiscard]] Vec3 viewUp() const;
  /// To be shared with another view of the same model; setPose() emits no signal.
  [[nodiscard]] Pose pose() const;
  void setPose(const Pose& pose);
  /// The camera as numbers: world mm LPS <-> logical pixels of this widget.
  [[nodiscard]] ViewCamera camera() const;
  /// Where the plane's handles are now; nothing without a plane.
  [[nodiscard]] std::optional<HandleLayout> handles() const;
  /// Begins to point: picked() or pickCancelled() (Escape, or another pick) ends it. The handles rest meanwhile.
  void startPick(PickKind kind);
  void cancelPick();
  [[nodiscard]] bool picking() const;
  /// The nearest point of a visible structure at a pixel.
  [[nodiscard]] std::optional<Vec3> surfaceAt(const Pixel& pixel) const;

 signals:
  /// A handle was grasped, moved (each mouse move), released. From grasp to release is one undo step.
  void planeDragStarted();
  void planeDragged(const glisson::ResectionPlane& plane);
  void planeDragFinished(const glisson::ResectionPlane& plane);
  /// One of the control points, 0..15, was grasped.
  void controlPointChosen(int point);
  void picked(const glisson::Pick& pick);
  void pickCancelled();
  void mapShownChanged(bool shown);
  /// Double click: the layout maximises this view or restores.
  void maximiseRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void stepPlane(const ResectionPlane& to);
  void showPick();
  void endPick();
  [[nodiscard]] bool movePlaneByKey(const QKeyEvent& event);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
