#include "app/gui/plane_editor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <map>
#include <numbers>
#include <span>

#include "viewer/bend_handles.h"

namespace glisson {

namespace {

QDoubleSpinBox* makeField(QWidget* parent, const QString& name, double limit, int decimals, double step) {
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(name);
  field->setRange(-limit, limit);
  field->setDecimals(decimals);
  field->setSingleStep(step);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setKeyboardTracking(false);
  field->setAlignment(Qt::AlignRight);
  field->setMinimumWidth(56);
  return field;
}

QToolButton* makeButton(QWidget* parent, const QString& name, Qt::ArrowType arrow) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setArrowType(arrow);
  button->setAutoRepeat(false);
  return button;
}

}  // namespace

PlaneEditor::PlaneEditor(QWidget* parent)
    : Translated<QGroupBox>(parent),
      place_(new QPushButton(this)),
      placeOtherwise_(makeButton(this, "placeOtherwise", Qt::DownArrow)),
      flip_(new QPushButton(this)),
      remove_(new QPushButton(this)),
      originLabel_(new QLabel(this)),
      normalLabel_(new QLabel(this)),
      moveLabel_(new QLabel(this)),
      tiltLabel_(new QLabel(this)),
      moveStep_(makeField(this, "moveStep", 50, 1, 1)),
      tiltStep_(makeField(this, "tiltStep", 45, 1, 1)),
      bend_(new QPushButton(this)),
      bendLabel_(new QLabel(this)),
      bendMoves_(new QComboBox(this)),
      flat_(new QPushButton(this)),
      pointLabel_(new QLabel(this)),
      point_(new QSpinBox(this)),
      height_(makeField(this, "controlHeight", kMostBendMm, 1, 1)) {
  setObjectName("planeEditor");
  place_->setObjectName("placePlane");
  flip_->setObjectName("flipPlane");
  remove_->setObjectName("removePlane");
  bend_->setObjectName("bendPlane");
  bend_->setCheckable(true);
  bendMoves_->setObjectName("bendMoves");
  bendMoves_->addItems({QString(), QString()});
  bendMoves_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  bendMoves_->setMinimumContentsLength(8);
  flat_->setObjectName("flattenPlane");
  point_->setObjectName("controlPoint");
  point_->setRange(1, 16);
  point_->setWrapping(true);
  constexpr std::array kAxes{"X", "Y", "Z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin_[axis] = makeField(this, QString("origin") + kAxes[axis], 5000, 1, 1);
    normal_[axis] = makeField(this, QString("normal") + kAxes[axis], 1, 3, 0.01);
  }
  move_ = {makeButton(this, "moveBack", Qt::LeftArrow), makeButton(this, "moveForward", Qt::RightArrow)};
  tilt_ = {makeButton(this, "tiltLeft", Qt::LeftArrow), makeButton(this, "tiltRight", Qt::RightArrow),
           makeButton(this, "tiltUp", Qt::UpArrow), makeButton(this, "tiltDown", Qt::DownArrow)};
  moveStep_->setRange(0.1, 50);
  moveStep_->setValue(2);
  tiltStep_->setRange(0.1, 45);
  tiltStep_->setValue(2);
  build();

  connect(place_, &QPushButton::clicked, this, &PlaneEditor::placeRequested);
  connect(remove_, &QPushButton::clicked, this, &PlaneEditor::removeRequested);
  connect(flip_, &QPushButton::clicked, this, [this] {
    if (plane_) {
      emit planeEdited({plane_->origin, -plane_->normal});
    }
  });
  connect(bend_, &QPushButton::toggled, this, &PlaneEditor::tellBending);
  connect(bendMoves_, &QComboBox::activated, this, &PlaneEditor::tellBending);
  connect(flat_, &QPushButton::clicked, this, &PlaneEditor::flattenRequested);
  connect(point_, &QSpinBox::valueChanged, this, [this](int number) {
    showHeight();
    emit controlPointChosen(number - 1);
  });
  connect(height_, &QDoubleSpinBox::editingFinished, this, &PlaneEditor::commitHeight);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    connect(origin_[axis], &QDoubleSpinBox::editingFinished, this, &PlaneEditor::commitFields);
    connect(normal_[axis], &QDoubleSpinBox::editingFinished, this, &PlaneEditor::commitNormal);
  }
  connect(move_[0], &QToolButton::clicked, this, [this] { emit moveRequested(-moveStepMm()); });
  connect(move_[1], &QToolButton::clicked, this, [this] { emit moveRequested(moveStepMm()); });
  connect(tilt_[0], &QToolButton::clicked, this, [this] { emit tiltRequested(tiltStepRadians(), 0); });
  connect(tilt_[1], &QToolButton::clicked, this, [this] { emit tiltRequested(-tiltStepRadians(), 0); });
  connect(tilt_[2], &QToolButton::clicked, this, [this] { emit tiltRequested(0, tiltStepRadians()); });
  connect(tilt_[3], &QToolButton::clicked, this, [this] { emit tiltRequested(0, -tiltStepRadians()); });
  retranslateUi();
  updateEnabled();
}

void PlaneEditor::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 4, 6, 6);
  grid->setVerticalSpacing(3);
  auto* first = new QHBoxLayout;
  first->setSpacing(2);
  first->addWidget(place_, 1);
  first->addWidget(placeOtherwise_);
  placeOtherwise_->setPopupMode(QToolButton::InstantPopup);
  grid->addLayout(first, 0, 0, 1, 4);
  grid->addWidget(originLabel_, 1, 0);
  grid->addWidget(normalLabel_, 2, 0);
  for (int axis = 0; axis < 3; ++axis) {
    grid->addWidget(origin_[static_cast<std::size_t>(axis)], 1, axis + 1);
    grid->addWidget(normal_[static_cast<std::size_t>(axis)], 2, axis + 1);
  }
  const auto addRow = [this, grid](int row, QLabel* label, QDoubleSpinBox* step, std::span<QToolButton* const> buttons) {
    grid->addWidget(label, row, 0);
    grid->addWidget(step, row, 1);
    auto* line = new QHBoxLayout;
    line->setSpacing(2);
    for (QToolButton* button : buttons) {
      line->addWidget(button);
    }
    line->addStretch(1);
    grid->addLayout(line, row, 2, 1, 2);
  };
  addRow(3, moveLabel_, moveStep_, move_);
  addRow(4, tiltLabel_, tiltStep_, tilt_);
  auto* last = new QHBoxLayout;
  last->addWidget(flip_);
  last->addWidget(remove_);
  grid->addLayout(last, 5, 0, 1, 4);
  auto* bending = new QHBoxLayout;
  bending->addWidget(bend_);
  bending->addWidget(flat_);
  grid->addLayout(bending, 6, 0, 1, 4);
  grid->addWidget(bendLabel_, 7, 0);
  grid->addWidget(bendMoves_, 7, 1, 1, 3);
  grid->addWidget(pointLabel_, 8, 0);
  grid->addWidget(point_, 8, 1);
  grid->addWidget(height_, 8, 2, 1, 2);
}

void PlaneEditor::tellBending() { emit bendingChanged(bend_->isChecked(), bendMoves_->currentIndex() == 1); }

void PlaneEditor::retranslateUi() {
  setTitle(tr("Resection plane"));
  place_->setText(tr("Place plane on the liver"));
  flip_->setText(tr("Swap sides"));
  remove_->setText(tr("Remove plane"));
  bend_->setText(tr("Bend"));
  bendLabel_->setText(tr("Drag"));
  bendMoves_->setItemText(0, tr("one point"));
  bendMoves_->setItemText(1, tr("its group"));
  flat_->setText(tr("Flat"));
  originLabel_->setText(tr("Origin"));
  originLabel_->setToolTip(tr("A point of the plane, mm: to the patient's left, posterior, superior"));
  normalLabel_->setText(tr("Normal"));
  normalLabel_->setToolTip(tr("The direction that points to the resected side; made one long when entered"));
  moveLabel_->setText(tr("Move"));
  tiltLabel_->setText(tr("Tilt"));
  moveStep_->setSuffix(QStringLiteral(" mm"));
  tiltStep_->setSuffix(QStringLiteral("\u00B0"));
  pointLabel_->setText(tr("Point"));
  height_->setSuffix(QStringLiteral(" mm"));
  for (QDoubleSpinBox* field : findChildren<QDoubleSpinBox*>()) {
    field->setLocale(QLocale());
  }
  updateEnabled();
}

void PlaneEditor::setPlane(const std::optional<ResectionPlane>& plane) {
  plane_ = plane;
  const HalfSpace shown = plane.value_or(HalfSpace{Vec3::Zero(), Vec3::Zero()});
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const QSignalBlocker quietOrigin(origin_[at]);
    const QSignalBlocker quietNormal(normal_[at]);
    origin_[at]->setValue(shown.origin[axis]);
    normal_[at]->setValue(shown.normal[axis]);
  }
  if (bend_->isChecked() && !(plane && plane->bend)) {
    bend_->setChecked(false);  // flattened, undone, or another plane is worked on
  }
  showHeight();
  updateEnabled();
}

void PlaneEditor::setControlPoint(int point) {
  const QSignalBlocker quiet(point_);
  point_->setValue(point + 1);
  showHeight();
}

void PlaneEditor::showHeight() {
  const QSignalBlocker quiet(height_);
  height_->setValue(plane_ && plane_->bend ? plane_->bend->heightsMm[static_cast<std::size_t>(point_->value() - 1)] : 0.0);
}

void PlaneEditor::commitHeight() {
  if (!plane_ || !plane_->bend) {
    return;
  }
  const auto point = static_cast<std::size_t>(point_->value() - 1);
  const double before = plane_->bend->heightsMm[point];
  const double typed = height_->value();
  if (std::abs(typed - before) > 0.051) {  // a field that still shows the rounded old height keeps the exact one
    Bend bend = *lifted(*plane_, point, bendMoves_->currentIndex() == 1, typed - before).bend;
    bend.heightsMm[point] = typed;
    emit bendEdited(bend);
  }
}

void PlaneEditor::setPlaceMenu(QMenu* menu) { placeOtherwise_->setMenu(menu); }

void PlaneEditor::setPlaceRefusal(const QString& reason) {
  place_->setEnabled(reason.isEmpty());
  placeOtherwise_->setEnabled(reason.isEmpty());
  placeOtherwise_->setToolTip(reason.isEmpty() ? tr("Place the plane in another way") : reason);
  place_->setToolTip(reason.isEmpty() ? tr("Through the middle of the liver, edge-on as seen in the 3D view (P)") : reason);
}

double PlaneEditor::moveStepMm() const { return moveStep_->value(); }

double PlaneEditor::tiltStepRadians() const { return tiltStep_->value() * std::numbers::pi / 180.0; }

void PlaneEditor::commitNormal() {
  // on the way from one component to the next the three numbers are no direction yet: wait for Enter or for leaving them
  const QObject* sender = QObject::sender();
  const bool onTheWay = std::ranges::any_of(
      normal_, [this, sender](QDoubleSpinBox* field) { return field != sender && field == window()->focusWidget(); });
  if (!onTheWay) {
    commitFields();
  }
}

void PlaneEditor::commitFields() {
  if (!plane_) {
    return;
  }
  HalfSpace typed = *plane_;
  bool changed = false;
  // a field that still shows the rounded old value keeps the exact old value
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    origin_[at]->interpretText();  // what was typed counts, left or not
    normal_[at]->interpretText();
    if (std::abs(origin_[at]->value() - typed.origin[axis]) > 0.051) {
      typed.origin[axis] = origin_[at]->value();
      changed = true;
    }
    if (std::abs(normal_[at]->value() - typed.normal[axis]) > 0.00051) {
      typed.normal[axis] = normal_[at]->value();
      changed = true;
    }
  }
  if (typed.normal.norm() < 1e-3) {
    setPlane(plane_);
    emit normalRefused();
    return;
  }
  if (changed) {
    typed.normal.normalize();
    emit planeEdited(typed);
  }
}

void PlaneEditor::updateEnabled() {
  const QString reason = plane_ ? QString() : tr("Place a plane first.");
  const std::map<const QWidget*, QString> tips{
      {move_[0], tr("Move towards the remnant")},         {move_[1], tr("Move towards the resected side")},
      {tilt_[0], tr("Turn left as seen in the 3D view")}, {tilt_[1], tr("Turn right as seen in the 3D view")},
      {tilt_[2], tr("Turn up as seen in the 3D view")},   {tilt_[3], tr("Turn down as seen in the 3D view")}};
  for (QWidget* control : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    if (control == place_ || control == placeOtherwise_ || qobject_cast<QLabel*>(control) != nullptr) {
      continue;
    }
    control->setEnabled(plane_.has_value());
    const auto tip = tips.find(control);
    control->setToolTip(plane_ && tip != tips.end() ? tip->second : reason);
  }
  const bool bent = plane_ && plane_->bend;
  bendMoves_->setEnabled(bent && bend_->isChecked());
  point_->setEnabled(bendMoves_->isEnabled());
  height_->setEnabled(bendMoves_->isEnabled());
  flat_->setEnabled(bent);
  if (plane_) {
    bend_->setToolTip(tr("Show 16 control points and drag them along the normal: the plane becomes a Bezier surface"));
    bendMoves_->setToolTip(bendMoves_->isEnabled()
                               ? tr("What a drag moves: one point, or all corners, edge or inner points (Shift)")
                               : tr("Press Bend first."));
    point_->setToolTip(point_->isEnabled()
                           ? tr("The control point whose height is shown, highlighted in the 3D view: a click on it "
                                "there chooses it, too")
                           : tr("Press Bend first."));
    height_->setToolTip(height_->isEnabled() ? tr("The control point's height over the plane, towards the resected side; its group "
                                                  "moves along where groups are dragged")
                                             : tr("Press Bend first."));
    flat_->setToolTip(bent ? tr("Make the bent surface the plane again") : tr("The plane is flat."));
  }
}

}  // namespace glisson
