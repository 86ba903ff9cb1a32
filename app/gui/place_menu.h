#pragma once
// Purpose: the ways to place a plane, as a menu. Knows which are possible now; asks by signals.

#include <QMenu>
#include <array>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "planning/resection/place_plane.h"
#include "viewer/pick_tool.h"

namespace glisson {

class PlaceMenu : public Translated<QMenu> {
  Q_OBJECT
 public:
  explicit PlaceMenu(Document& document, QWidget* parent = nullptr);

 signals:
  void pickRequested(glisson::PickKind kind);
  void sliceRequested(glisson::SlicePlane slice);
  /// At the safety margin of the plan.
  void tumourRequested(const QString& id);

 protected:
  void retranslateUi() override;

 private:
  void refresh();

  Document& document_;
  std::array<QAction*, 3> picks_{};
  std::array<QAction*, 3> slices_{};
  QMenu* tumours_;
};

}  // namespace glisson
