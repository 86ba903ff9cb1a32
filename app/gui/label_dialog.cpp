#include "app/gui/label_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
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

void LabelDialog::updateAccept() {
  const bool complete = std::ranges::all_of(choices_, [](const auto& choice) { return choice->currentData().toInt() >= 0; });
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
