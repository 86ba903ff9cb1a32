#include "app/gui/territory_box.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "app/gui/file_dialog.h"
#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/reading_question.h"
#include "app/gui/sentences.h"
#include "planning/territories/branch_owners.h"

namespace glisson {

namespace {

constexpr int kTerritoryListHeight = 92;

QString mlOrUnknown(const std::optional<double>& ml) { return ml ? mlText(*ml, 1) : TerritoryBox::tr("not known"); }

constexpr int kSwatchPixels = 12;
constexpr double kTubeShare = 0.5;  ///< of the vessel's radius: the tube lies inside the vessel
constexpr double kLeastTubeMm = 0.8;
constexpr double kMostTubeMm = 2.5;

/// The territory's colour in the view and beside its row; `place`: in the report and among the picks.
Rgb colourOf(const std::string& name, std::size_t place) {
  return name == kNotPicked ? kNoTerritoryColour : territoryColour(place);
}

QIcon swatchOf(Rgb colour) {
  QPixmap square(kSwatchPixels, kSwatchPixels);
  square.fill(QColor(colour.r, colour.g, colour.b));
  QIcon icon(square);
  icon.addPixmap(square, QIcon::Disabled);  // out of date are the numbers, not the colours
  return icon;
}

std::vector<DrawnTerritory> drawnTerritories(const VesselGraph& portal, const TerritoryChoice& choice) {
  std::vector<DrawnTerritory> drawn;
  for (std::size_t n = 0; n < choice.picks.size(); ++n) {
    const std::string& name = choice.picks[n].name;
    const QString shown = choice.confirmed ? territoryName(name) : TerritoryBox::tr("%1 (proposed)").arg(territoryName(name));
    drawn.push_back({shown.toStdString(), colourOf(name, n), {}});
  }
  drawn.push_back({{}, kNoTerritoryColour, {}});  // what is not picked, and what owns nothing
  const std::vector<std::int32_t> owners = ownersOfBranches(portal, choice);
  for (std::size_t n = 0; n < owners.size(); ++n) {
    const VesselBranch& branch = portal.branches[n];
    const double radius = std::clamp(kTubeShare * branch.meanRadiusMm, kLeastTubeMm, kMostTubeMm);
    DrawnTerritory& owner = owners[n] == kOwnsNothing ? drawn.back() : drawn[static_cast<std::size_t>(owners[n])];
    owner.branches.push_back({branch.lineMm, radius});
  }
  return drawn;
}

}  // namespace

QString territoryName(const std::string& name) {
  if (name == "left") {
    return TerritoryBox::tr("left");
  }
  if (name == "right") {
    return TerritoryBox::tr("right");
  }
  constexpr std::string_view kSegment = "segment ";
  if (name.starts_with(kSegment)) {
    return TerritoryBox::tr("segment %1").arg(QString::fromStdString(name.substr(kSegment.size())));
  }
  return name == "unassigned" ? TerritoryBox::tr("unassigned") : shownName(name);
}

QString tumourTerritoriesText(const TumourTerritories& tumour) {
  QStringList parts;
  for (const TerritoryShare& share : tumour.shares) {
    parts << QStringLiteral("%1 %2 (%3)").arg(territoryName(share.name), mlText(share.volumeMl, 1), percentText(share.percent));
  }
  return parts.isEmpty() ? TerritoryBox::tr("none of them") : parts.join(QStringLiteral(", "));
}

QString perfusionText(const PerfusionEstimate& effect) {
  if (!effect.isKnown()) {
    return TerritoryBox::tr("Estimate: no vessel inside the liver is labelled, so nothing is known of the remnant's blood.");
  }
  return TerritoryBox::tr("Estimate of the remnant: devascularised %1, congested %2, either %3. FLR without them %4, %5.")
      .arg(mlOrUnknown(effect.devascularisedMl), mlOrUnknown(effect.congestedMl), mlText(effect.devascularisedOrCongestedMl, 1),
           mlText(effect.perfusedFlrMl, 1), percentText(effect.perfusedFlrPercent, 1));
}

TerritoryBox::TerritoryBox(Document& document, TerritoryEstimator& estimator, QWidget* parent)
    : Translated<QGroupBox>(parent),
      document_(document),
      estimator_(estimator),
      estimate_(new QPushButton(this)),
      confirm_(new QPushButton(this)),
      pick_(new QPushButton(this)),
      propose_(new QPushButton(this)),
      segments_(new QPushButton(this)),
      shown_(new QCheckBox(this)),
      parts_(new QTreeWidget(this)),
      perfusion_(new QLabel(this)),
      notes_(new QLabel(this)) {
  setObjectName("territoryBox");
  estimate_->setObjectName("estimateTerritories");
  confirm_->setObjectName("confirmTerritories");
  pick_->setObjectName("pickTerritory");
  propose_->setObjectName("proposeTerritories");
  segments_->setObjectName("segmentTerritories");
  shown_->setObjectName("showTerritories");
  shown_->setChecked(true);
  parts_->setObjectName("territoryTable");
  perfusion_->setObjectName("perfusionText");
  notes_->setObjectName("territoryNotes");
  makeNarrow(*parts_, 3);
  parts_->setSelectionMode(QAbstractItemView::NoSelection);
  parts_->setFixedHeight(kTerritoryListHeight);
  perfusion_->setWordWrap(true);
  notes_->setWordWrap(true);
  notes_->setTextFormat(Qt::PlainText);  // a path from a case file stands in them
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(4, 2, 4, 4);
  grid->addWidget(estimate_, 0, 0, 1, 2);
  grid->addWidget(parts_, 1, 0, 1, 2);
  grid->addWidget(shown_, 2, 0, 1, 2);
  grid->addWidget(confirm_, 3, 0, 1, 2);
  grid->addWidget(pick_, 4, 0);
  grid->addWidget(propose_, 4, 1);
  grid->addWidget(segments_, 5, 0, 1, 2);
  grid->addWidget(perfusion_, 6, 0, 1, 2);
  grid->addWidget(notes_, 7, 0, 1, 2);

  connect(estimate_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::estimate);
  connect(confirm_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::confirm);
  connect(shown_, &QCheckBox::toggled, this, &TerritoryBox::refresh);
  connect(propose_, &QPushButton::clicked, &estimator_, &TerritoryEstimator::propose);
  connect(segments_, &QPushButton::clicked, this, &TerritoryBox::chooseSegments);
  connect(pick_, &QPushButton::clicked, this, [this] {
    view_->startPick(PickKind::Branch);
    view_->setFocus();
    emit hint(tr("Click a branch of the portal vein in the 3D view: it and all behind it become a territory. Escape ends."));
  });
  connect(&estimator_, &TerritoryEstimator::changed, this, &TerritoryBox::refresh);
  connect(&estimator_, &TerritoryEstimator::mapRefused, this,
          [this](const QString& path, const ReadOptions& options, const QString& sentence) {
            const auto again = [this, path](const ReadOptions& answered) { estimator_.chooseSegments(path, answered); };
            if (!askToRead(this, sentence, options, again)) {
              emit refused(sentence);
            }
          });
  connect(&document_, &Document::caseChanged, this, &TerritoryBox::refresh);
  retranslateUi();
}

void TerritoryBox::pointIn(ModelView& view) {
  view_ = &view;
  connect(view_, &ModelView::picked, this, [this](const Pick& pick) {
    if (pick.kind == PickKind::Branch) {
      emit hint({});
      estimator_.pick(pick.points.front());
    }
  });
  refreshButtons();
  refreshBranches();
}

void TerritoryBox::chooseSegments() {
  QFileDialog* dialog = makeFileDialog(this, "segmentMapDialog", tr("Choose a map of liver segments 1 to 8"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters({tr("Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    rememberFolder({path});
    estimator_.chooseSegments(path);
  });
  dialog->open();
}

void TerritoryBox::retranslateUi() {
  setTitle(tr("Territories (estimates)"));
  estimate_->setText(tr("Estimate territories"));
  confirm_->setText(tr("Left and right are right"));
  pick_->setText(tr("Pick a branch"));
  propose_->setText(tr("Left and right"));
  segments_->setText(tr("Segments from a file..."));
  segments_->setToolTip(tr("A map with labels 1 to 8 on the grid of the CT, instead of branches; the case keeps where it lies"));
  shown_->setText(tr("Branches in the 3D view"));
  parts_->setHeaderLabels({tr("Territory"), tr("Volume"), tr("Resected")});
  refresh();
}

void TerritoryBox::refresh() {
  const bool known =
      estimator_.state() == TerritoryEstimator::State::Current || estimator_.state() == TerritoryEstimator::State::Following;
  estimate_->setVisible(!known);
  for (QWidget* part : std::initializer_list<QWidget*>{parts_, shown_, pick_, propose_, segments_, perfusion_, notes_}) {
    part->setVisible(known);
  }
  confirm_->setVisible(known && estimator_.isProposal());
  parts_->setEnabled(estimator_.report() != nullptr);
  perfusion_->setEnabled(estimator_.report() != nullptr);
  parts_->setToolTip(estimator_.report() != nullptr ? QString() : tr("Out of date until the plane rests"));
  if (estimator_.report() != nullptr) {
    refreshNumbers(*estimator_.report());
  }
  refreshButtons();
  refreshBranches();
}

void TerritoryBox::refreshBranches() {
  if (view_ != nullptr) {
    const VesselGraph* portal = shown_->isChecked() && !estimator_.hasSegments() ? estimator_.portal() : nullptr;
    view_->setTerritories(portal != nullptr ? drawnTerritories(*portal, estimator_.choice()) : std::vector<DrawnTerritory>());
  }
}

void TerritoryBox::refreshButtons() {
  QString reason;
  if (!document_.isOpen()) {
    reason = tr("Open a case first.");
  } else if (estimator_.state() == TerritoryEstimator::State::Computing) {
    reason = tr("The vessels' trees are being computed.");
  }
  estimate_->setEnabled(reason.isEmpty());
  estimate_->setToolTip(
      reason.isEmpty() ? tr("Which part of the liver hangs on which branch, and what the plan cuts off from blood") : reason);
  confirm_->setEnabled(shown_->isChecked());
  confirm_->setToolTip(confirm_->isEnabled() ? tr("You have looked at the proposed left and right and found them right")
                                             : tr("Show the branches in the 3D view and look at them first."));
  pick_->setEnabled(view_ != nullptr);
  const bool otherwise = estimator_.isPicked() || estimator_.hasSegments();
  propose_->setEnabled(otherwise);
  propose_->setToolTip(otherwise ? tr("Back to left and right as proposed") : tr("Left and right are shown already."));
  shown_->setEnabled(!estimator_.hasSegments());
  shown_->setToolTip(
      shown_->isEnabled()
          ? tr("The portal branches, each in the colour of the territory that hangs on it; grey ones belong to none of them")
          : tr("The segments of a map hang on no branches."));
}

void TerritoryBox::refreshNumbers(const TerritoryReport& report) {
  parts_->clear();
  for (std::size_t n = 0; n < report.volumes.size(); ++n) {
    const TerritoryVolume& part = report.volumes[n];
    auto* row = new QTreeWidgetItem(parts_, {territoryName(part.name), mlText(part.volumeMl), mlText(part.resectedMl)});
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    row->setIcon(0, swatchOf(colourOf(part.name, n)));
    row->setToolTip(0, tr("%1 of it stays").arg(mlText(part.remnantMl, 1)));
  }
  perfusion_->setText(perfusionText(report.effect));
  QStringList notes;
  for (const std::string& note : report.notes) {
    notes << shownSentence(note);
  }
  notes_->setText(notes.join('\n'));
  notes_->setVisible(!notes.isEmpty());
}

}  // namespace glisson
