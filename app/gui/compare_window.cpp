#include "app/gui/compare_window.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
#include "planning/report/compare_plans.h"

namespace glisson {

namespace {

constexpr std::size_t kMostCompared = 4;

struct RowText {
  std::string_view id;
  const char* name;
  const char* unit;
  int decimals;
};
constexpr auto kRows = std::to_array<RowText>({
    {"resections", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Resections"), "", 0},
    {"planes", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Planes"), "", 0},
    {"safetyMarginMm", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Safety margin"), "mm", 1},
    {"resectedMl", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Resected"), "mL", 0},
    {"remnantMl", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Remnant"), "mL", 0},
    {"functionalRemnantMl", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Functional remnant (FLR)"), "mL", 0},
    {"flrPercent", QT_TRANSLATE_NOOP("glisson::CompareWindow", "FLR of the functional liver"), "%", 1},
    {"cutAreaMm2", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Area of the cut"), "cm\u00B2", 1},
    {"tumoursRemoved", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Tumours removed"), "", 0},
    {"tumoursCut", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Tumours cut"), "", 0},
    {"tumoursLeft", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Tumours left"), "", 0},
    {"leastMarginMm", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Least margin, at least"), "mm", 1},
    {"vesselsCrossed", QT_TRANSLATE_NOOP("glisson::CompareWindow", "Vessels of 3 mm and more crossed"), "", 0},
});

QString valueText(const RowText& row, double value) {
  const double shown = row.id == "cutAreaMm2" ? value / 100 : value;
  const QString unit = QString::fromUtf8(row.unit);
  return numberText(shown, row.decimals) + (unit.isEmpty() ? QString() : QStringLiteral("\u00A0") + unit);
}

}  // namespace

CompareWindow::CompareWindow(Document& document, std::vector<std::shared_ptr<const DisplayMesh>> ready, QWidget* parent)
    : Translated<QWidget>(parent, Qt::Window),
      document_(document),
      ready_(std::move(ready)),
      choice_(new QToolButton(this)),
      row_(new QHBoxLayout),
      table_(new QTreeWidget(this)),
      differences_(new QLabel(this)) {
  setObjectName("compareWindow");
  setAttribute(Qt::WA_DeleteOnClose);
  resize(1200, 800);
  choice_->setObjectName("comparedPlans");
  choice_->setPopupMode(QToolButton::InstantPopup);
  choice_->setMenu(new QMenu(choice_));
  table_->setObjectName("comparedTable");
  table_->setRootIsDecorated(false);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  differences_->setObjectName("comparedDifferences");
  differences_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(choice_, 0, Qt::AlignLeft);
  column->addLayout(row_, 3);
  column->addWidget(table_, 2);
  column->addWidget(differences_);
  connect(&document_, &Document::caseChanged, this, &QWidget::close);
  connect(&document_, &Document::planChanged, this, &CompareWindow::refresh);
  connect(&document_, &Document::modelChanged, this, &CompareWindow::refresh);
  connect(&document_, &Document::plansAssessed, this, &CompareWindow::showNumbers);
  choose({});
  retranslateUi();
}

void CompareWindow::choose(std::vector<std::size_t> plans) {
  const std::size_t count = document_.content().plans.size();
  std::erase_if(plans, [&](std::size_t plan) { return plan >= count; });
  for (std::size_t n = 0; n < count && plans.size() < 2; ++n) {
    if (std::ranges::find(plans, n) == plans.end()) {
      plans.push_back(n);
    }
  }
  std::ranges::sort(plans);
  plans.resize(std::min(plans.size(), kMostCompared));
  chosen_ = std::move(plans);
  makeViews();
  refresh();
}

void CompareWindow::makeViews() {
  while (views_.size() > chosen_.size()) {
    delete views_.back()->parentWidget();
    views_.pop_back();
    names_.pop_back();
  }
  while (views_.size() < chosen_.size()) {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    auto* name = new QLabel(panel);
    auto* view = new ModelView(panel);
    view->setObjectName(QStringLiteral("comparedView%1").arg(views_.size()));
    view->setHandlesShown(false);
    column->addWidget(name);
    column->addWidget(view, 1);
    row_->addWidget(panel, 1);
    connect(view, &ModelView::cameraMoved, this, [this, view] {
      for (ModelView* other : views_) {
        if (other != view) {
          other->setPose(view->pose());
        }
      }
    });
    names_.push_back(name);
    views_.push_back(view);
  }
}

void CompareWindow::retranslateUi() {
  setWindowTitle(tr("Compare plans"));
  choice_->setText(tr("Plans compared"));
  refresh();
}

bool CompareWindow::chosenExist() const {
  return document_.isOpen() &&
         std::ranges::all_of(chosen_, [&](std::size_t plan) { return plan < document_.content().plans.size(); });
}

void CompareWindow::refresh() {
  const std::vector<ResectionPlan>& plans = document_.content().plans;
  if (!chosenExist()) {
    if (document_.isOpen() && plans.size() >= 2) {
      choose(chosen_);
    } else {
      close();
    }
    return;
  }
  QStringList headers{tr("Value")};
  for (std::size_t n = 0; n < chosen_.size(); ++n) {
    const ResectionPlan& plan = plans[chosen_[n]];
    names_[n]->setText(shownName(plan.name));
    headers << shownName(plan.name);
    views_[n]->setModel(document_.content().model, ready_);
    views_[n]->setTumours(document_.tumourDistance());
    views_[n]->setPlan(plan);
  }
  table_->setColumnCount(static_cast<int>(chosen_.size()) + 1);
  table_->setHeaderLabels(headers);
  QMenu* menu = choice_->menu();
  menu->clear();
  for (std::size_t plan = 0; plan < plans.size(); ++plan) {
    QAction* action = menu->addAction(shownName(plans[plan].name));
    action->setCheckable(true);
    action->setChecked(std::ranges::find(chosen_, plan) != chosen_.end());
    const bool free = action->isChecked() ? chosen_.size() > 2 : chosen_.size() < kMostCompared;
    action->setEnabled(free);
    action->setToolTip(free ? QString() : tr("Two to four plans are compared."));
    connect(action, &QAction::triggered, this, [this, plan](bool wanted) {
      std::vector<std::size_t> next = chosen_;
      std::erase(next, plan);
      if (wanted) {
        next.push_back(plan);
      }
      QMetaObject::invokeMethod(
          this, [this, next] { choose(next); }, Qt::QueuedConnection);  // the menu that asks is made anew
    });
  }
  menu->setToolTipsVisible(true);
  table_->setEnabled(false);
  table_->setToolTip(tr("Out of date until the plane rests"));
  document_.assessPlans();
}

void CompareWindow::showNumbers(const std::vector<PlanAssessment>& assessments) {
  const std::vector<ResectionPlan>& plans = document_.content().plans;
  if (assessments.size() != plans.size() || !chosenExist()) {
    return;
  }
  std::vector<AssessedPlan> compared;
  for (const std::size_t plan : chosen_) {
    compared.push_back({plans[plan], assessments[plan]});
  }
  const PlanComparison comparison = comparePlans(compared);
  table_->clear();
  for (const ComparedRow& row : comparison.rows) {
    const auto* text = std::ranges::find(kRows, row.id, &RowText::id);
    if (text == kRows.end()) {
      continue;
    }
    auto* item = new QTreeWidgetItem(table_, {tr(text->name)});
    for (std::size_t n = 0; n < row.values.size(); ++n) {
      const int column = static_cast<int>(n) + 1;
      QString value = row.values[n] ? valueText(*text, *row.values[n]) : QStringLiteral("-");
      if (row.largest[n]) {
        value += QStringLiteral("  \u25B2 ") + tr("largest");
      } else if (row.smallest[n]) {
        value += QStringLiteral("  \u25BC ") + tr("smallest");
      }
      item->setText(column, value);
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  for (int column = 0; column < table_->columnCount(); ++column) {
    table_->header()->setSectionResizeMode(column, QHeaderView::Stretch);
  }
  table_->setEnabled(true);
  table_->setToolTip({});
  QStringList sentences;
  if (compared.size() == 2) {
    for (const std::string& sentence : differenceOf(compared[0], compared[1])) {
      sentences << shownSentence(sentence);
    }
  }
  differences_->setText(sentences.join(QStringLiteral("\n")));
  differences_->setVisible(!sentences.isEmpty());
}

}  // namespace glisson
