#include "app/gui/case_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/gui/label_dialog.h"
#include "app/gui/model_builder.h"
#include "app/gui/number_text.h"
#include "app/gui/sentences.h"

namespace glisson {

CasePanel::CasePanel(Document& document, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      open_(new QPushButton(this)),
      loaded_(new QLabel(this)),
      labelsTitle_(new QLabel(this)),
      labels_(new QTreeWidget(this)),
      notesTitle_(new QLabel(this)),
      notes_(new QListWidget(this)) {
  setObjectName("casePanel");
  open_->setObjectName("caseOpen");
  labels_->setObjectName("labelTable");
  labels_->setRootIsDecorated(false);
  labels_->setSelectionMode(QAbstractItemView::NoSelection);
  labels_->header()->setStretchLastSection(true);
  notes_->setObjectName("noteList");
  notes_->setWordWrap(true);
  notes_->setSelectionMode(QAbstractItemView::NoSelection);
  notes_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  loaded_->setWordWrap(true);
  loaded_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addWidget(open_);
  column->addWidget(loaded_);
  column->addWidget(labelsTitle_);
  column->addWidget(labels_, 1);
  column->addWidget(notesTitle_);
  column->addWidget(notes_, 1);
  connect(open_, &QPushButton::clicked, this, &CasePanel::openRequested);
  connect(&document_, &Document::caseChanged, this, &CasePanel::refresh);
  connect(&document_, &Document::ctChanged, this, &CasePanel::refresh);
  connect(&document_, &Document::notesChanged, this, &CasePanel::refreshNotes);
  connect(&document_, &Document::modelChanged, this, &CasePanel::refreshNotes);
  retranslateUi();
}

void CasePanel::retranslateUi() {
  open_->setText(tr("Open files..."));
  open_->setToolTip(tr("A CT with its segmentation, or a case (Ctrl+O)"));
  labelsTitle_->setText(tr("Which label is what"));
  labels_->setHeaderLabels({tr("Label"), tr("Structure")});
  refresh();
}

void CasePanel::refresh() {
  const Case& content = document_.content();
  QStringList lines;
  if (content.segmentation) {
    const ImageGeometry& grid = content.segmentation->geometry;
    lines << (content.ct ? tr("CT: %1").arg(shownSentence(content.ct->source)) : tr("No CT is shown."));
    lines << tr("Labels: %1").arg(shownSentence(content.segmentation->source));
    lines << tr("Grid: %1 x %2 x %3 voxels of %4 x %5 x %6 mm")
                 .arg(QString::number(grid.size[0]), QString::number(grid.size[1]), QString::number(grid.size[2]),
                      numberText(grid.spacing[0], 2), numberText(grid.spacing[1], 2), numberText(grid.spacing[2], 2));
  } else {
    lines << tr("Nothing is loaded.");
  }
  loaded_->setText(lines.join('\n'));
  labels_->clear();
  if (content.segmentation) {
    for (const LabelledMask& mask : content.segmentation->structures) {
      auto* row = new QTreeWidgetItem(labels_, {shownName(mask.name), kindName(mask.kind.value_or(StructureKind::Other))});
      row->setToolTip(0, row->text(0));
      row->setToolTip(1, row->text(1));
    }
    labels_->resizeColumnToContents(0);
  }
  refreshNotes();
}

void CasePanel::refreshNotes() {
  notes_->clear();
  const Case& content = document_.content();
  for (const auto* notes : {&content.notes, &content.ctNotes}) {
    for (const std::string& note : *notes) {
      notes_->addItem(shownSentence(note));
    }
  }
  if (content.model) {
    for (const Structure& structure : content.model->structures) {
      if (!structure.reconstruction) {
        continue;
      }
      for (const std::string& deviation : structure.reconstruction->deviations) {
        auto* item = new QListWidgetItem(tr("%1 deviates: %2").arg(structureName(structure), shownSentence(deviation)), notes_);
        item->setIcon(style()->standardIcon(QStyle::SP_MessageBoxWarning));
      }
      for (const std::string& note : structure.reconstruction->notes) {
        notes_->addItem(structureName(structure) + QStringLiteral(": ") + shownSentence(note));
      }
    }
  }
  notesTitle_->setText(tr("Problems and notes: %1").arg(notes_->count()));
}

}  // namespace glisson
