#pragma once
// Purpose: models A and B of the lab as pictures: side by side with one camera, in one view with a line to swipe, or as outlines
// over the CT; coloured on one scale; the numbers of each below.

#include <QWidget>
#include <array>

#include "app/gui/document.h"
#include "app/gui/lab_columns.h"
#include "app/gui/translated.h"
#include "viewer/slice_view.h"
#include "viewer/surface_view.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace glisson {

class ErrorLegend;
class LabSide;

enum class LabLook : std::uint8_t { SideBySide, Swipe, Slices };

class LabViews : public Translated<QWidget> {
  Q_OBJECT
 public:
  LabViews(Document& document, std::array<LabSide*, 2> sides, QWidget* parent);

  void setLook(LabLook look);
  [[nodiscard]] LabLook look() const { return look_; }
  [[nodiscard]] SurfaceView& view(std::size_t side) { return *views_[side]; }
  /// The structure whose voxels are outlined in the slices; the crosshair goes to its middle.
  void setStructure(const Structure& structure);
  /// What is known of each side now; a row without a model: nothing. To be told again in another language.
  void setNumbers(const std::array<LabRow, 2>& rows);

 protected:
  void retranslateUi() override;

 private:
  void build();
  void refresh();
  void refreshSlices();
  void refreshNames();
  [[nodiscard]] QString numbersOf(const LabRow& row) const;
  void setCrosshair(const Vec3& worldMm);

  Document& document_;
  std::array<LabSide*, 2> sides_;
  QButtonGroup* looks_;
  std::array<QToolButton*, 3> lookButtons_{};
  QCheckBox* wireframe_;
  ErrorLegend* legend_;
  QStackedWidget* pages_;  ///< surfaces, slices
  std::array<QWidget*, 2> panels_{};
  std::array<SurfaceView*, 2> views_{};
  QLabel* swipeBadge_ = nullptr;  ///< B's letter in the first view
  std::array<SliceView*, 3> slices_{};
  std::array<QLabel*, 2> names_{};
  std::array<QLabel*, 2> numbers_{};
  Structure structure_;
  LabLook look_ = LabLook::SideBySide;
};

}  // namespace glisson
