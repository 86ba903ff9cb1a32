#include "app/gui/plan_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include "app/gui/sentences.h"
#include "app/jobs/job_runner.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

QComboBox* makeChoice(const QString& name, QWidget* parent) {
  auto* choice = new QComboBox(parent);
  choice->setObjectName(name);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(8);
  choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return choice;
}

QToolButton* makeMenuButton(const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setMenu(new QMenu(button));
  return button;
}

}  // namespace

PlanBar::PlanBar(Document& document, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      planLabel_(new QLabel(this)),
      plans_(makeChoice("planChoice", this)),
      planMenuButton_(makeMenuButton("planMenu", this)),
      planeLabel_(new QLabel(this)),
      planes_(makeChoice("planeChoice", this)),
      planeMenuButton_(makeMenuButton("planeMenu", this)),
      marginLabel_(new QLabel(this)),
      margin_(new QDoubleSpinBox(this)),
      newPlan_(planMenuButton_->menu()->addAction(QString())),
      duplicate_(planMenuButton_->menu()->addAction(QString())),
      rename_(planMenuButton_->menu()->addAction(QString())),
      delete_(planMenuButton_->menu()->addAction(QString())),
      compare_(planMenuButton_->menu()->addAction(QString())),
      addResection_(planeMenuButton_->menu()->addAction(QString())),
      addPlane_(planeMenuButton_->menu()->addAction(QString())) {
  setObjectName("planBar");
  newPlan_->setObjectName("actionNewPlan");
  duplicate_->setObjectName("actionDuplicatePlan");
  rename_->setObjectName("actionRenamePlan");
  delete_->setObjectName("actionDeletePlan");
  compare_->setObjectName("actionComparePlans");
  addResection_->setObjectName("actionAddResection");
  addPlane_->setObjectName("actionAddPlane");
  margin_->setObjectName("safetyMargin");
  margin_->setRange(0, 100);
  margin_->setDecimals(1);
  margin_->setKeyboardTracking(false);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  grid->addWidget(planLabel_, 0, 0);
  grid->addWidget(plans_, 0, 1);
  grid->addWidget(planMenuButton_, 0, 2);
  grid->addWidget(planeLabel_, 1, 0);
  grid->addWidget(planes_, 1, 1);
  grid->addWidget(planeMenuButton_, 1, 2);
  grid->addWidget(marginLabel_, 2, 0);
  grid->addWidget(margin_, 2, 1);

  connect(plans_, &QComboBox::activated, this, [this](int index) { document_.choose({static_cast<std::size_t>(index), 0, 0}); });
  connect(planes_, &QComboBox::activated, this, [this](int index) {
    const QSize place = planes_->itemData(index).toSize();
    document_.choose({document_.chosen().plan, static_cast<std::size_t>(place.width()), static_cast<std::size_t>(place.height())});
  });
  connect(margin_, &QDoubleSpinBox::valueChanged, this, [this](double mm) { tryTo([&] { document_.edit(SetSafetyMargin{mm}); }); });
  connect(newPlan_, &QAction::triggered, this, [this] { tryTo([this] { document_.addPlan(); }); });
  connect(duplicate_, &QAction::triggered, this, [this] { tryTo([this] { document_.duplicatePlan(); }); });
  connect(delete_, &QAction::triggered, this, [this] { tryTo([this] { document_.removePlan(); }); });
  connect(compare_, &QAction::triggered, this, &PlanBar::compareRequested);
  connect(rename_, &QAction::triggered, this, &PlanBar::askForName);
  connect(addResection_, &QAction::triggered, this, &PlanBar::resectionRequested);
  connect(addPlane_, &QAction::triggered, this, &PlanBar::planeRequested);
  connect(&document_, &Document::planChanged, this, &PlanBar::refresh);
  connect(&document_, &Document::caseChanged, this, &PlanBar::refresh);
  retranslateUi();
}

void PlanBar::retranslateUi() {
  planLabel_->setText(tr("Plan"));
  planeLabel_->setText(tr("Plane"));
  marginLabel_->setText(tr("Safety margin"));
  margin_->setSuffix(QStringLiteral(" mm"));
  margin_->setLocale(QLocale());
  planMenuButton_->setText(QStringLiteral("..."));
  planeMenuButton_->setText(QStringLiteral("..."));
  planMenuButton_->setAccessibleName(tr("Edit the list of plans"));
  planeMenuButton_->setAccessibleName(tr("Add planes"));
  newPlan_->setText(tr("New plan"));
  duplicate_->setText(tr("Duplicate plan"));
  rename_->setText(tr("Rename plan..."));
  delete_->setText(tr("Delete plan"));
  compare_->setText(tr("Compare plans..."));
  addResection_->setText(tr("Add a resection"));
  addPlane_->setText(tr("Add a plane to this resection"));
  refresh();
}

void PlanBar::refresh() {
  const QSignalBlocker quietPlans(plans_);
  const QSignalBlocker quietMargin(margin_);
  plans_->clear();
  for (const ResectionPlan& plan : document_.content().plans) {
    plans_->addItem(shownName(plan.name));
  }
  plans_->setCurrentIndex(static_cast<int>(document_.chosen().plan));
  margin_->setValue(document_.plan().safetyMarginMm);
  refreshPlanes();
  const bool open = document_.isOpen();
  const QString reason = open ? QString() : tr("Open a case first.");
  for (QWidget* control : std::initializer_list<QWidget*>{plans_, planMenuButton_, margin_}) {
    control->setEnabled(open);
    control->setToolTip(reason);
  }
  if (open) {
    planMenuButton_->setToolTip(tr("Edit the list of plans"));
    margin_->setToolTip(tr("Margins below it are shown in red; planes around a tumour are proposed for it"));
  }
  const bool plane = document_.plane().has_value();
  planes_->setEnabled(plane);
  planeMenuButton_->setEnabled(plane);
  planes_->setToolTip(plane ? tr("The plane that is shown with handles and moved") : tr("Place a plane first."));
  planeMenuButton_->setToolTip(plane ? tr("Add planes") : tr("Place a plane first."));
  delete_->setEnabled(document_.content().plans.size() > 1);
  delete_->setToolTip(delete_->isEnabled() ? QString() : tr("A case keeps at least one plan."));
  compare_->setEnabled(delete_->isEnabled());
  compare_->setToolTip(compare_->isEnabled() ? QString() : tr("Duplicate this plan or make a new one first."));
}

void PlanBar::refreshPlanes() {
  const QSignalBlocker quiet(planes_);
  planes_->clear();
  const std::vector<Resection>& resections = document_.plan().resections;
  for (std::size_t r = 0; r < resections.size(); ++r) {
    for (std::size_t p = 0; p < resections[r].planes.size(); ++p) {
      const QString name = shownName(resections[r].name);
      planes_->addItem(resections[r].planes.size() > 1 ? tr("%1, plane %2").arg(name).arg(p + 1) : name,
                       QSize(static_cast<int>(r), static_cast<int>(p)));
      if (r == document_.chosen().resection && p == document_.chosen().plane) {
        planes_->setCurrentIndex(planes_->count() - 1);
      }
    }
  }
}

void PlanBar::askForName() {
  const QString now = QString::fromStdString(document_.plan().name);
  bool accepted = false;
  const QString name = QInputDialog::getText(this, tr("Rename plan"), tr("Name of the plan:"), QLineEdit::Normal, now, &accepted);
  if (accepted) {
    tryTo([&] { document_.renamePlan(name.toStdString()); });
  }
}

void PlanBar::tryTo(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    emit refused(messageOf(error));
    refresh();
  }
}

}  // namespace glisson
