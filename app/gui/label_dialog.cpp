#include "app/gui/label_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
#include "reconstruction/image/label_tables.h"
#include "reconstruction/image/liver_voxels.h"

namespace glisson {

QString kindName(StructureKind kind) {
  switch (kind) {
    case StructureKind::Liver:
      return QCoreApplication::translate("StructureKind", "Parenchyma");
    case StructureKind::PortalVein:
      return QCoreApplication::translate("StructureKind", "Portal vein");
    case StructureKind::HepaticVein:
      return QCoreApplication::translate("StructureKind", "Hepatic vein");
    case StructureKind::VenaCava:
      return QCoreApplication::translate("StructureKind", "Vena cava");
    case StructureKind::Artery:
      return QCoreApplication::translate("StructureKind", "Artery");
    case StructureKind::Tumour:
      return QCoreApplication::translate("StructureKind", "Tumour");
    case StructureKind::Cyst:
      return QCoreApplication::translate("StructureKind", "Cyst");
    case StructureKind::Gallbladder:
      return QCoreApplication::translate("StructureKind", "Gallbladder");
    case StructureKind::BileDuct:
      return QCoreApplication::translate("StructureKind", "Bile duct");
    case StructureKind::Other:
      break;
  }
  return QCoreApplication::translate("StructureKind", "Not part of the liver model");
}

LabelDialog::LabelDialog(const std::vector<LabelledMask>& unknown, const ImageGeometry& geometry, QWidget* parent)
    : QDialog(parent) {
  setObjectName("labelDialog");
  setWindowTitle(tr("Which label is what?"));
  auto* layout = new QVBoxLayout(this);
  auto* intro = new QLabel(tr("These labels carry no name Glisson knows. Choose what each one is; nothing is guessed."), this);
  intro->setWordWrap(true);
  layout->addWidget(intro);
  layout->addWidget(makeShortcuts());

  auto* list = new QWidget(this);
  auto* grid = new QGridLayout(list);
  grid->setColumnStretch(0, 1);
  int row = 0;
  for (const LabelledMask& label : unknown) {
    grid->addWidget(new QLabel(shownName(label.name), list), row, 0);
    const double ml = label.mask ? volumeMl(*label.mask, geometry) : 0.0;
    grid->addWidget(new QLabel(mlText(ml, 1), list), row, 1);
    auto* choice = new QComboBox(list);
    choice->setObjectName("labelKind" + QString::number(row));
    choice->addItem(tr("Choose..."), -1);
    for (const StructureKind kind : kAllStructureKinds) {
      choice->addItem(kindName(kind), static_cast<int>(kind));
    }
    connect(choice, &QComboBox::currentIndexChanged, this, &LabelDialog::updateAccept);
    grid->addWidget(choice, row, 2);
    choices_.push_back(choice);
    labels_.push_back(label.label);
    ++row;
  }
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(list);
  layout->addWidget(scroll, 1);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  acceptButton_ = buttons->button(QDialogButtonBox::Ok);
  acceptButton_->setObjectName("labelAccept");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  resize(560, 360);
  updateAccept();
}

QWidget* LabelDialog::makeShortcuts() {
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  table_ = new QComboBox(line);
  table_->setObjectName("labelTable");
  table_->addItem(tr("no table: chosen one by one"), QString());
  for (const auto& [text, id] :
       {std::pair("TotalSegmentator v2", "totalsegmentator"), std::pair("TotalSegmentator v1", "totalsegmentator-v1"),
        std::pair("TotalSegmentator MR", "totalsegmentator-mr")}) {
    table_->addItem(QString::fromLatin1(text), QString::fromLatin1(id));
  }
  connect(table_, &QComboBox::currentIndexChanged, this, &LabelDialog::showTable);
  auto* others = new QPushButton(tr("All others: not part of the model"), line);
  others->setObjectName("labelOthers");
  connect(others, &QPushButton::clicked, this, [this] {
    for (QComboBox* choice : choices_) {
      if (choice->currentData().toInt() < 0) {
        choice->setCurrentIndex(choice->findData(static_cast<int>(StructureKind::Other)));
      }
    }
  });
  row->addWidget(new QLabel(tr("Numbers of"), line));
  row->addWidget(table_);
  row->addStretch(1);
  row->addWidget(others);
  return line;
}

void LabelDialog::showTable() {
  const std::map<int, std::string> names = labelTableNames(table());
  for (std::size_t n = 0; n < choices_.size(); ++n) {
    choices_[n]->setEnabled(names.empty());
    const auto name = names.find(labels_[n]);
    const bool known = name != names.end();
    const int kind = known ? static_cast<int>(recogniseKind(name->second).value_or(StructureKind::Other)) : -1;
    choices_[n]->setCurrentIndex(choices_[n]->findData(kind));
    choices_[n]->setToolTip(known ? QString::fromStdString(name->second) : QString());
  }
  updateAccept();
}

std::string LabelDialog::table() const { return table_->currentData().toString().toStdString(); }

void LabelDialog::updateAccept() {
  const bool complete =
      !table().empty() || std::ranges::all_of(choices_, [](const auto& choice) { return choice->currentData().toInt() >= 0; });
  acceptButton_->setEnabled(complete);
  acceptButton_->setToolTip(complete ? QString() : tr("Choose a kind for every label first."));
}

std::vector<StructureKind> LabelDialog::chosen() const {
  std::vector<StructureKind> kinds;
  std::ranges::transform(choices_, std::back_inserter(kinds),
                         [](const QComboBox* choice) { return static_cast<StructureKind>(choice->currentData().toInt()); });
  return kinds;
}

}  // namespace glisson
