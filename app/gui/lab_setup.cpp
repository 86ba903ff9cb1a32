#include "app/gui/lab_setup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "app/gui/lab_columns.h"
#include "app/gui/lab_experiment.h"
#include "app/gui/model_builder.h"
#include "app/gui/number_text.h"
#include "app/lab/accuracy_figure.h"
#include "reconstruction/evaluation/rated_recipes.h"
#include "reconstruction/reconstruct.h"

namespace glisson {

namespace {
constexpr int kLeastDepth = 5;
constexpr int kFirstDepth = 7;
constexpr double kPublishedScale = 1.25;  ///< of the authors' base code
}  // namespace

LabSetup::LabSetup(Document& document, LabExperiment& experiment, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      experiment_(experiment),
      structureTitle_(new QLabel(this)),
      structures_(new QComboBox(this)),
      familiesTitle_(new QLabel(this)),
      optionsTitle_(new QLabel(this)),
      sampling_(new QComboBox(this)),
      scale_(new QComboBox(this)),
      compare_(new QPushButton(this)),
      cancel_(new QPushButton(this)),
      rate_(new QPushButton(this)),
      progress_(new QLabel(this)),
      depthTitle_(new QLabel(this)),
      depth_(new QSlider(Qt::Horizontal, this)),
      depthA_(new QRadioButton(QStringLiteral("A"), this)),
      depthB_(new QRadioButton(QStringLiteral("B"), this)),
      exportTitle_(new QLabel(this)),
      csv_(new QPushButton(this)),
      png_(new QPushButton(this)),
      svg_(new QPushButton(this)) {
  setObjectName("labSetup");
  for (const ModelFamily family : lab::familiesOf(allRecipes())) {
    auto* box = new QCheckBox(this);
    box->setObjectName("labFamily_" + QString::fromStdString(std::string(familyId(family))));
    box->setChecked(true);
    families_.push_back(box);
  }
  build();
  connectParts();
  retranslateUi();
}

void LabSetup::build() {
  structures_->setObjectName("labStructure");
  sampling_->setObjectName("labSampling");
  scale_->setObjectName("labScale");
  compare_->setObjectName("labCompare");
  cancel_->setObjectName("labCancel");
  rate_->setObjectName("labRate");
  progress_->setObjectName("labProgress");
  depth_->setObjectName("labDepth");
  depthA_->setObjectName("labDepthA");
  depthB_->setObjectName("labDepthB");
  csv_->setObjectName("labCsv");
  png_->setObjectName("labPng");
  svg_->setObjectName("labSvg");
  sampling_->addItems({{}, {}});
  scale_->addItems({{}, {}});
  progress_->setWordWrap(true);
  compare_->setDefault(true);
  structures_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  depth_->setRange(kLeastDepth, kDeepestPsr);
  depth_->setValue(kFirstDepth);
  depth_->setPageStep(1);
  depth_->setTickPosition(QSlider::TicksBelow);
  depth_->setTickInterval(1);
  depthA_->setChecked(true);
  for (QLabel* title : {structureTitle_, familiesTitle_, optionsTitle_, depthTitle_, exportTitle_}) {
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(3);
  column->addWidget(structureTitle_);
  column->addWidget(structures_);
  column->addSpacing(4);
  column->addWidget(familiesTitle_);
  for (QCheckBox* family : families_) {
    column->addWidget(family);
  }
  column->addSpacing(4);
  column->addWidget(optionsTitle_);
  column->addWidget(sampling_);
  column->addWidget(scale_);
  column->addSpacing(6);
  column->addWidget(compare_);
  column->addWidget(cancel_);
  column->addWidget(progress_);
  column->addWidget(rate_);
  column->addSpacing(6);
  column->addWidget(depthTitle_);
  column->addWidget(depth_);
  auto* sides = new QHBoxLayout;
  sides->addWidget(depthA_);
  sides->addWidget(depthB_);
  sides->addStretch(1);
  column->addLayout(sides);
  column->addStretch(1);
  column->addWidget(exportTitle_);
  column->addWidget(csv_);
  auto* pictures = new QHBoxLayout;
  pictures->addWidget(png_);
  pictures->addWidget(svg_);
  column->addLayout(pictures);
}

void LabSetup::connectParts() {
  connect(structures_, &QComboBox::currentIndexChanged, this, &LabSetup::subjectChanged);
  for (QComboBox* option : {sampling_, scale_}) {
    connect(option, &QComboBox::activated, this, &LabSetup::subjectChanged);
  }
  for (QCheckBox* family : families_) {
    connect(family, &QCheckBox::toggled, this, &LabSetup::refresh);
  }
  connect(compare_, &QPushButton::clicked, this, &LabSetup::compareRequested);
  connect(cancel_, &QPushButton::clicked, &experiment_, &LabExperiment::cancel);
  connect(rate_, &QPushButton::clicked, this, &LabSetup::ratingRequested);
  connect(depth_, &QSlider::valueChanged, this, [this](int depth) {
    refresh();
    emit depthChosen(depth);
  });
  // the depth that the slider stands at can be wished for, too
  connect(depth_, &QSlider::sliderReleased, this, [this] { emit depthChosen(depth_->value()); });
  connect(csv_, &QPushButton::clicked, this, &LabSetup::csvRequested);
  connect(png_, &QPushButton::clicked, this, &LabSetup::pngRequested);
  connect(svg_, &QPushButton::clicked, this, &LabSetup::svgRequested);
  connect(&experiment_, &LabExperiment::changed, this, &LabSetup::refresh);
  connect(&document_, &Document::caseChanged, this, &LabSetup::listStructures);
}

void LabSetup::retranslateUi() {
  structureTitle_->setText(tr("Structure"));
  familiesTitle_->setText(tr("Methods"));
  optionsTitle_->setText(tr("PSR is given"));
  sampling_->setItemText(0, tr("samples as published"));
  sampling_->setItemText(1, tr("unbiased samples"));
  sampling_->setToolTip(
      tr("As published, samples are voxel centres, half a voxel inside; unbiased ones lie on the voxels' faces."));
  scale_->setItemText(0, tr("a cube of 1.1"));
  scale_->setItemText(1, tr("a cube of 1.25"));
  scale_->setToolTip(tr("The cube that PSR solves in, in sizes of the structure; the authors' base code has 1.25."));
  compare_->setText(tr("Compare methods"));
  cancel_->setText(tr("Cancel"));
  rate_->setText(tr("Blind rating..."));
  depth_->setToolTip(tr("The PSR model of this depth is made and shown at once."));
  depthA_->setToolTip(tr("The slider's model becomes A."));
  depthB_->setToolTip(tr("The slider's model becomes B."));
  exportTitle_->setText(tr("Export"));
  csv_->setText(tr("Table as CSV..."));
  png_->setText(tr("Plot PNG..."));
  svg_->setText(tr("Plot SVG..."));
  const std::vector<ModelFamily> families = lab::familiesOf(allRecipes());
  for (std::size_t n = 0; n < families.size(); ++n) {
    families_[n]->setText(labFamilyName(families[n]));
  }
  listStructures();
}

void LabSetup::listStructures() {
  const Structure* before = structure();
  const QString id = before != nullptr ? QString::fromStdString(before->id) : QString();
  {
    const QSignalBlocker quiet(structures_);
    structures_->clear();
    if (document_.isOpen() && document_.content().model) {
      for (const Structure& structure : document_.content().model->structures) {
        if (isModelled(structure)) {
          structures_->addItem(structureName(structure), QString::fromStdString(structure.id));
        }
      }
    }
    structures_->setCurrentIndex(std::max(0, structures_->findData(id)));
  }
  refresh();
}

const Structure* LabSetup::structure() const {
  if (!document_.isOpen() || !document_.content().model) {
    return nullptr;
  }
  return document_.content().model->find(structures_->currentData().toString().toStdString());
}

std::vector<ModelFamily> LabSetup::families() const {
  const std::vector<ModelFamily> all = lab::familiesOf(allRecipes());
  std::vector<ModelFamily> chosen;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (families_[n]->isChecked()) {
      chosen.push_back(all[n]);
    }
  }
  return chosen;
}

ExperimentOptions LabSetup::options() const {
  ExperimentOptions options;
  options.sampling = sampling_->currentIndex() == 0 ? Sampling::Paper : Sampling::Unbiased;
  options.scale = scale_->currentIndex() == 0 ? options.scale : kPublishedScale;
  return options;
}

std::size_t LabSetup::depthSide() const { return depthB_->isChecked() ? 1 : 0; }

QString LabSetup::refusal() const {
  if (structure() == nullptr) {
    return tr("Open a case first.");
  }
  if (experiment_.running()) {
    return tr("The methods are being compared.");
  }
  if (families().empty()) {
    return tr("Choose a method.");
  }
  return experiment_.missing(families()).empty() ? tr("Every model of these methods is there.") : QString();
}

void LabSetup::refresh() {
  const QString reason = refusal();
  compare_->setEnabled(reason.isEmpty());
  compare_->setToolTip(reason.isEmpty() ? tr("Makes and measures the models that are missing; each appears as soon as it is done.")
                                        : reason);
  cancel_->setEnabled(experiment_.running());
  cancel_->setToolTip(experiment_.running() ? tr("Models that are done stay.") : tr("Nothing is being compared."));
  rate_->setEnabled(structure() != nullptr);
  if (structure() == nullptr) {
    rate_->setToolTip(tr("Open a case first."));
  } else if (hasRatedGroups(experiment_.evaluation())) {
    rate_->setToolTip(
        tr("Shows the best PSR, the best MCSD and the MCSD most similar to that PSR to raters one at a time, without names."));
  } else {
    rate_->setToolTip(tr("Makes models of this structure by PSR and MCSD and shows them to raters one at a time, without names."));
  }
  const std::size_t there = experiment_.evaluation().models.size();
  const std::size_t failed = experiment_.evaluation().failed();
  QString text = tr("%1 of %2 models").arg(there).arg(allRecipes().size());
  if (failed > 0) {
    text += QStringLiteral(", ") + tr("%1 could not be made (see the table)").arg(failed);
  }
  progress_->setText(text);
  depthTitle_->setText(tr("PSR depth %1, shown as").arg(depth_->value()));
  depth_->setEnabled(structure() != nullptr);
  const bool any = there > failed;
  const QString nothing = tr("There are no models yet.");
  csv_->setEnabled(there > 0);
  csv_->setToolTip(there > 0 ? tr("Every measure of every model") : nothing);
  for (QPushButton* button : {png_, svg_}) {
    button->setEnabled(any);
    button->setToolTip(any ? tr("The plot as a picture") : nothing);
  }
}

}  // namespace glisson
