#pragma once
// Purpose: places planes in the document: as seen, by pointing in the 3D view, along the slices, around a tumour, by steps. Where
// the plan has a plane, the one that is worked on goes there; one around a tumour gets a resection of its own where that plane
// bounds one with others. Frame: mm LPS.

#include <QObject>
#include <optional>

#include "app/gui/document.h"
#include "app/gui/view_area.h"
#include "planning/resection/place_plane.h"
#include "planning/volumetry/margin_plane.h"

namespace glisson {

class PlaceMenu;

class PlanePlacer : public QObject {
  Q_OBJECT
 public:
  PlanePlacer(JobRunner& jobs, Document& document, ViewArea& views, QWidget* parent);

  [[nodiscard]] PlaceMenu& menu() { return *menu_; }

  /// Through the liver's centre, edge-on as seen in the 3D view.
  void placeAsSeen();
  /// One more plane, as seen: in a resection of its own, or in that worked on.
  void addAsSeen(bool ownResection);
  void moveBy(double mm);
  /// Radians about the 3D view's up axis and right axis.
  void tilt(double aboutUp, double aboutRight);

 signals:
  void placed();
  void refused(const QString& sentence);  ///< in English
  /// What to do next while pointing; empty: done.
  void hint(const QString& text);

 private:
  void startPick(PickKind kind);
  void onPicked(const Pick& pick);
  void placeAlongSlice(SlicePlane slice);
  void placeAroundTumour(const std::string& id);
  /// `asked`: the plan that the proposal was asked for.
  void onProposed(const MarginProposal& proposal, const ResectionPlan& asked);
  /// Places what `make` gives, or tells why there is none.
  void place(const std::function<HalfSpace()>& make);

  JobRunner& jobs_;
  Document& document_;
  ViewArea& views_;
  PlaceMenu* menu_;
};

}  // namespace glisson
