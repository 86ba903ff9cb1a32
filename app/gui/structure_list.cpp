#include "app/gui/structure_list.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <limits>

#include "app/gui/acceptance_box.h"
#include "app/gui/label_dialog.h"
#include "app/gui/model_builder.h"
#include "app/gui/narrow_table.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"

namespace glisson {

namespace {

constexpr int kIdRole = Qt::UserRole + 1;

QColor toColour(Rgb rgb) { return {rgb.r, rgb.g, rgb.b}; }

QIcon swatch(const QColor& colour) {
  QPixmap picture(14, 14);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setPen(QColor(90, 90, 90));
  painter.setBrush(colour);
  painter.drawRect(1, 1, 11, 11);
  return picture;
}

}  // namespace

StructureList::StructureList(Document& document, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      tree_(new QTreeWidget(this)),
      opacityLabel_(new QLabel(this)),
      opacity_(new QSlider(Qt::Horizontal, this)),
      colour_(new QPushButton(this)),
      acceptance_(new AcceptanceBox(document, *tree_, this)) {
  setObjectName("structureList");
  tree_->setObjectName("structureTree");
  makeNarrow(*tree_, 3);
  tree_->setUniformRowHeights(true);
  opacity_->setObjectName("opacitySlider");
  opacity_->setRange(0, 100);
  colour_->setObjectName("colourButton");

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(tree_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(opacityLabel_);
  row->addWidget(opacity_, 1);
  row->addWidget(colour_);
  layout->addLayout(row);
  layout->addWidget(acceptance_);

  connect(&document_, &Document::caseChanged, this, &StructureList::rebuild);
  connect(&document_, &Document::modelChanged, this, &StructureList::refresh);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, &StructureList::refreshControls);
  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (!refreshing_ && column == 0) {
      document_.setVisible(item->data(0, kIdRole).toString().toStdString(), item->checkState(0) == Qt::Checked);
    }
  });
  connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
    if (!refreshing_ && selected() != nullptr) {
      document_.setOpacity(selectedId(), percent / 100.0);
    }
  });
  connect(colour_, &QPushButton::clicked, this, &StructureList::chooseColour);
  retranslateUi();
}

std::string StructureList::selectedId() const {
  const QList<QTreeWidgetItem*> items = tree_->selectedItems();
  return items.isEmpty() ? std::string() : items.front()->data(0, kIdRole).toString().toStdString();
}

const Structure* StructureList::selected() const {
  const Case& content = document_.content();
  return content.model ? content.model->find(selectedId()) : nullptr;
}

void StructureList::retranslateUi() {
  tree_->setHeaderLabels({tr("Structure"), tr("Voxels"), QStringLiteral("\u2713")});
  tree_->headerItem()->setToolTip(1, tr("Volume of the labelled voxels"));
  tree_->headerItem()->setToolTip(2, tr("Accepted by a person"));
  opacityLabel_->setText(tr("Opacity"));
  colour_->setText(tr("Colour..."));
  refresh();
}

void StructureList::rebuild() {
  refreshing_ = true;
  tree_->clear();
  const Case& content = document_.content();
  if (content.model) {
    for (const Structure& structure : content.model->structures) {
      auto* item = new QTreeWidgetItem(tree_);
      item->setData(0, kIdRole, QString::fromStdString(structure.id));
      item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  refreshing_ = false;
  refresh();
  if (tree_->topLevelItemCount() > 0) {
    tree_->topLevelItem(0)->setSelected(true);
  }
}

void StructureList::refresh() {
  refreshing_ = true;
  const Case& content = document_.content();
  for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& item = *tree_->topLevelItem(i);
    const Structure* structure = content.model ? content.model->find(item.data(0, kIdRole).toString().toStdString()) : nullptr;
    if (structure != nullptr) {
      refreshItem(item, *structure);
    }
  }
  refreshing_ = false;
  refreshControls();
}

void StructureList::refreshItem(QTreeWidgetItem& item, const Structure& structure) {
  const bool built = structure.reconstruction != nullptr;
  const bool warned = built && (!structure.reconstruction->deviations.empty() || structure.reconstruction->defects.any());
  item.setText(0, structureName(structure));
  item.setIcon(0, swatch(toColour(structure.colour)));
  item.setCheckState(0, structure.visible ? Qt::Checked : Qt::Unchecked);
  item.setText(1, mlText(voxelVolumeOf(document_.content(), structure), 1));
  item.setForeground(
      0, built ? palette().brush(QPalette::Active, QPalette::Text) : palette().brush(QPalette::Disabled, QPalette::Text));
  item.setIcon(1, warned ? style()->standardIcon(QStyle::SP_MessageBoxWarning) : QIcon());
  const QString report = structureReport(structure);
  item.setToolTip(0, report);
  item.setToolTip(1, report);
  item.setText(2, structure.acceptance ? QStringLiteral("\u2713") : QString());
  item.setToolTip(2, acceptanceText(structure));
}

void StructureList::refreshControls() {
  const Structure* structure = selected();
  const QString reason = structure == nullptr ? tr("Select a structure in the list first.") : QString();
  opacity_->setEnabled(structure != nullptr);
  colour_->setEnabled(structure != nullptr);
  opacity_->setToolTip(reason);
  colour_->setToolTip(reason);
  acceptance_->setStructure(structure != nullptr ? structure->id : std::string());
  if (structure != nullptr) {
    const bool before = refreshing_;
    refreshing_ = true;
    opacity_->setValue(qRound(structure->opacity * 100));
    refreshing_ = before;
  }
}

void StructureList::chooseColour() {
  const Structure* structure = selected();
  if (structure == nullptr) {
    return;
  }
  auto* dialog = new QColorDialog(toColour(structure->colour), this);
  dialog->setObjectName("colourDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  connect(dialog, &QColorDialog::colorSelected, this, [this, id = structure->id](const QColor& colour) {
    document_.setColour(id, Rgb{static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
                                static_cast<std::uint8_t>(colour.blue())});
  });
  dialog->open();
}

double voxelVolumeOf(const Case& content, const Structure& structure) {
  if (structure.reconstruction) {
    return structure.reconstruction->voxelVolumeMl;
  }
  if (structure.kind == StructureKind::Liver && content.liver) {
    return content.liver->totalMl();
  }
  if (!content.segmentation || structure.sourceIndex < 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const LabelledMask& source = content.segmentation->structures.at(static_cast<std::size_t>(structure.sourceIndex));
  return source.mask ? volumeMl(*source.mask, content.segmentation->geometry) : std::numeric_limits<double>::quiet_NaN();
}

QString structureReport(const Structure& structure) {
  QStringList lines{structureName(structure) + QStringLiteral(" (") + kindName(structure.kind) + QStringLiteral(")")};
  if (!structure.reconstruction) {
    lines << StructureList::tr("No surface yet.");
    return lines.join('\n');
  }
  const Reconstruction& made = *structure.reconstruction;
  lines << acceptanceText(structure);
  lines << shownSentence(made.parameters.describe());
  lines << StructureList::tr("Surface %1, voxels %2 (%3), %4 triangles")
               .arg(mlText(made.meshVolumeMl, 2), mlText(made.voxelVolumeMl, 2), percentText(made.volumeDeviation() * 100.0, 2),
                    numberText(static_cast<double>(made.mesh.triangles.size()), 0));
  for (const std::string& defect : made.defects.names()) {
    lines << StructureList::tr("Defect: %1").arg(shownSentence(defect));
  }
  for (const std::string& deviation : made.deviations) {
    lines << StructureList::tr("Deviation: %1").arg(shownSentence(deviation));
  }
  for (const std::string& note : made.notes) {
    lines << StructureList::tr("Note: %1").arg(shownSentence(note));
  }
  return lines.join('\n');
}

}  // namespace glisson
