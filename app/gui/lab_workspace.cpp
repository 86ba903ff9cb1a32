#include "app/gui/lab_workspace.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QSplitter>
#include <QTabWidget>

#include "app/gui/lab_experiment.h"
#include "app/gui/lab_plot.h"
#include "app/gui/lab_setup.h"
#include "app/gui/lab_side.h"
#include "app/gui/lab_table.h"
#include "app/gui/lab_views.h"
#include "app/gui/model_builder.h"
#include "app/lab/accuracy_svg.h"
#include "planning/case/structure_mask.h"
#include "planning/exchange/atomic_file.h"
#include "reconstruction/errors.h"
#include "reconstruction/evaluation/models_csv.h"

namespace glisson {

namespace {
constexpr int kPlotHeight = 250;  ///< to begin with
constexpr int kSetupWidth = 220;
}  // namespace

LabWorkspace::LabWorkspace(Document& document, JobRunner& jobs, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      experiment_(new LabExperiment(jobs, this)),
      sides_{new LabSide(jobs, QStringLiteral("A"), this), new LabSide(jobs, QStringLiteral("B"), this)},
      setup_(new LabSetup(document, *experiment_, this)),
      tabs_(new QTabWidget(this)),
      plot_(new LabPlot(tabs_)),
      table_(new LabTable(tabs_)),
      views_(new LabViews(document, sides_, this)) {
  setObjectName("labWorkspace");
  build();
  connectParts();
  retranslateUi();
  takeSubject();
}

void LabWorkspace::build() {
  tabs_->setObjectName("labTabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(plot_, QString());
  tabs_->addTab(table_, QString());
  auto* centre = new QSplitter(Qt::Vertical, this);
  centre->setChildrenCollapsible(false);
  centre->addWidget(tabs_);
  centre->addWidget(views_);
  centre->setStretchFactor(1, 1);
  centre->setSizes({kPlotHeight, 3 * kPlotHeight});
  setup_->setFixedWidth(kSetupWidth);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(setup_);
  row->addWidget(centre, 1);
}

void LabWorkspace::connectParts() {
  connect(&document_, &Document::caseChanged, this, &LabWorkspace::takeSubject);
  connect(&document_, &Document::ctChanged, this, [this] {
    if (const Structure* structure = setup_->structure()) {
      views_->setStructure(*structure);
    }
  });
  connect(setup_, &LabSetup::subjectChanged, this, &LabWorkspace::takeSubject);
  connect(setup_, &LabSetup::compareRequested, this, [this] {
    if (const Structure* structure = setup_->structure()) {
      experiment_->run(setup_->families(), tr("Comparing methods: %1").arg(structureName(*structure)));
    }
  });
  connect(setup_, &LabSetup::ratingRequested, this, [this] {
    if (const Structure* structure = setup_->structure()) {
      emit ratingRequested(*structure, ratedRecipes(experiment_->evaluation()), setup_->options());
    }
  });
  connect(setup_, &LabSetup::depthChosen, this, &LabWorkspace::showDepth);
  connect(setup_, &LabSetup::csvRequested, this,
          [this] { save(tr("Table as CSV"), "models.csv", tr("CSV (*.csv)"), &LabWorkspace::writeCsv); });
  connect(setup_, &LabSetup::pngRequested, this,
          [this] { save(tr("Plot as PNG"), "accuracy.png", tr("PNG (*.png)"), &LabWorkspace::writePng); });
  connect(setup_, &LabSetup::svgRequested, this,
          [this] { save(tr("Plot as SVG"), "accuracy.svg", tr("SVG (*.svg)"), &LabWorkspace::writeSvg); });
  connect(plot_, &LabPlot::chosen, this, &LabWorkspace::choose);
  connect(table_, &LabTable::chosen, this, &LabWorkspace::choose);
  connect(experiment_, &LabExperiment::changed, this, &LabWorkspace::refresh);
  connect(experiment_, &LabExperiment::failed, this, &LabWorkspace::refused);
  for (LabSide* side : sides_) {
    connect(side, &LabSide::changed, this, &LabWorkspace::refreshNumbers);
    connect(side, &LabSide::failed, this, &LabWorkspace::refused);
  }
}

void LabWorkspace::retranslateUi() {
  tabs_->setTabText(0, tr("Plot"));
  tabs_->setTabText(1, tr("Table"));
  plot_->setHint(
      tr("\"Compare methods\" makes the models of the chosen structure; each appears here as soon as it is measured. "
         "Click one to see it as A, click another with Shift or the right button to see it as B."));
  refreshNumbers();
}

void LabWorkspace::takeSubject() {
  const Structure* structure = setup_->structure();
  std::shared_ptr<const lab::LabSubject> subject;
  if (structure != nullptr) {
    const auto source = std::make_shared<const Case>(document_.content());
    subject = std::make_shared<const lab::LabSubject>(std::shared_ptr<const Mask>(source, &maskOf(*source, *structure)),
                                                      source->segmentation->geometry);
  }
  experiment_->setSubject(subject, setup_->options());
  for (LabSide* side : sides_) {
    side->setSubject(subject, setup_->options());
  }
  if (structure != nullptr) {
    views_->setStructure(*structure);
  }
}

void LabWorkspace::choose(std::size_t place, std::size_t side) {
  const EvaluatedModel& model = experiment_->evaluation().models[place];
  if (model.measures) {
    sides_[side]->show(model.recipe, true);
  }
}

void LabWorkspace::showDepth(int depth) {
  const ModelRecipe recipe{.family = ModelFamily::Psr, .depth = depth};
  sides_[setup_->depthSide()]->show(recipe, measuredPlaceOf(recipe).has_value());
}

std::optional<std::size_t> LabWorkspace::measuredPlaceOf(const ModelRecipe& recipe) const {
  const auto place = experiment_->placeOf(recipe);
  return place && experiment_->evaluation().models[*place].measures ? place : std::nullopt;
}

void LabWorkspace::refresh() {
  const Evaluation& evaluation = experiment_->evaluation();
  const double voxelMl = experiment_->subject() ? experiment_->subject()->voxelVolumeMl() : 0;
  plot_->setEvaluation(evaluation);
  table_->setEvaluation(evaluation, voxelMl);
  refreshNumbers();
}

void LabWorkspace::refreshNumbers() {
  const Evaluation& evaluation = experiment_->evaluation();
  const double voxelMl = experiment_->subject() ? experiment_->subject()->voxelVolumeMl() : 0;
  std::array<std::optional<std::size_t>, 2> chosen;
  std::array<std::optional<EvaluatedModel>, 2> beside;
  std::array<LabRow, 2> rows;
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const LabSide& shown = *sides_[side];
    if (!shown.recipe() || shown.pending()) {
      continue;
    }
    chosen[side] = measuredPlaceOf(*shown.recipe());
    if (chosen[side]) {
      rows[side] = {&evaluation.models[*chosen[side]], evaluation.finalScore(*chosen[side]), voxelMl};
    } else if (shown.model()) {
      rows[side] = {&*shown.model(), nullptr, voxelMl};
      beside[side] = shown.model()->measures ? shown.model() : std::nullopt;
    }
  }
  plot_->setChosen(chosen, beside);
  views_->setNumbers(rows);
}

void LabWorkspace::writeCsv(const QString& path) const {
  writeFileAtomically(path.toStdString(), modelsCsv(experiment_->evaluation(), experiment_->subject()->voxelVolumeMl()));
}

void LabWorkspace::writePng(const QString& path) const {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  plot_->picture().save(&bytes, "PNG");
  writeFileAtomically(path.toStdString(), bytes.data().toStdString());
}

void LabWorkspace::writeSvg(const QString& path) const {
  writeFileAtomically(path.toStdString(), lab::svgFile(lab::accuracySvg(experiment_->evaluation())));
}

void LabWorkspace::save(const QString& title, const QString& name, const QString& filter,
                        void (LabWorkspace::*write)(const QString&) const) {
  const QString path = QFileDialog::getSaveFileName(this, title, name, filter);
  if (path.isEmpty()) {
    return;
  }
  try {
    (this->*write)(path);
    emit written(path);
  } catch (const Error& error) {
    emit refused(messageOf(error));
  }
}

}  // namespace glisson
