#pragma once
// Purpose: everything the mouse does with the plane, exactly: origin and normal typed in (mm LPS), steps along the normal, tilts,
// sides swapped, bent, placed, removed. Knows no document: it asks by signals.

#include <QGroupBox>
#include <array>
#include <optional>

#include "app/gui/translated.h"
#include "planning/resection/bend.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace glisson {

class PlaneEditor : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit PlaneEditor(QWidget* parent = nullptr);

  void setPlane(const std::optional<ResectionPlane>& plane);
  /// The control point, 0..15, whose height is shown. Emits no signal.
  void setControlPoint(int point);
  /// The other ways to place it.
  void setPlaceMenu(QMenu* menu);
  /// Why no plane can be placed now; empty: it can.
  void setPlaceRefusal(const QString& reason);
  [[nodiscard]] double moveStepMm() const;
  [[nodiscard]] double tiltStepRadians() const;

 signals:
  void placeRequested();
  void removeRequested();
  void planeEdited(const glisson::HalfSpace& plane);
  /// Millimetres along the normal.
  void moveRequested(double mm);
  /// Radians about the picture's up axis and about its right axis.
  void tiltRequested(double aboutUp, double aboutRight);
  /// The plane shall be bent, where it is flat, and its control points shown; with their whole group they move where `group`.
  void bendingChanged(bool shown, bool group);
  void flattenRequested();
  /// The control point, 0..15, whose height is to be typed.
  void controlPointChosen(int point);
  /// A height was typed; the point's group moved along where groups are moved.
  void bendEdited(const glisson::Bend& bend);
  /// A normal of no length was typed: the fields were put back.
  void normalRefused();

 protected:
  void retranslateUi() override;

 private:
  void build();
  void commitFields();
  void commitNormal();
  void updateEnabled();
  void tellBending();
  void showHeight();
  void commitHeight();

  std::optional<ResectionPlane> plane_;
  QPushButton* place_;
  QToolButton* placeOtherwise_;
  QPushButton* flip_;
  QPushButton* remove_;
  QLabel* originLabel_;
  QLabel* normalLabel_;
  QLabel* moveLabel_;
  QLabel* tiltLabel_;
  std::array<QDoubleSpinBox*, 3> origin_{};
  std::array<QDoubleSpinBox*, 3> normal_{};
  QDoubleSpinBox* moveStep_;
  QDoubleSpinBox* tiltStep_;
  std::array<QToolButton*, 2> move_{};
  std::array<QToolButton*, 4> tilt_{};
  QPushButton* bend_;
  QLabel* bendLabel_;
  QComboBox* bendMoves_;
  QPushButton* flat_;
  QLabel* pointLabel_;
  QSpinBox* point_;
  QDoubleSpinBox* height_;
};

}  // namespace glisson
