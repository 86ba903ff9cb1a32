#include "app/gui/model_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/gui/structure_list.h"

namespace glisson {

ModelPanel::ModelPanel(Document& document, ModelBuilder& builder, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      builder_(builder),
      build_(new QPushButton(this)),
      summary_(new QLabel(this)),
      details_(new QTextBrowser(this)) {
  setObjectName("modelPanel");
  build_->setObjectName("reconstructModel");
  summary_->setObjectName("modelSummary");
  summary_->setWordWrap(true);
  details_->setObjectName("modelDetails");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addWidget(build_);
  column->addWidget(summary_);
  column->addWidget(details_, 1);
  connect(build_, &QPushButton::clicked, this, [this] { builder_.buildMissing(); });
  connect(&document_, &Document::caseChanged, this, &ModelPanel::refresh);
  connect(&document_, &Document::modelChanged, this, &ModelPanel::refresh);
  connect(&builder_, &ModelBuilder::changed, this, &ModelPanel::refresh);
  retranslateUi();
}

void ModelPanel::retranslateUi() {
  build_->setText(tr("Reconstruct model"));
  refresh();
}

void ModelPanel::refresh() {
  const int missing = builder_.missing();
  build_->setEnabled(missing > 0 && !builder_.building());
  if (!document_.isOpen()) {
    build_->setToolTip(tr("Open a case first."));
  } else if (builder_.building()) {
    build_->setToolTip(tr("The structures are being reconstructed."));
  } else if (missing == 0) {
    build_->setToolTip(tr("Every structure has its surface."));
  } else {
    build_->setToolTip(tr("Makes the surfaces that are missing."));
  }
  summary_->setText(document_.isOpen()
                        ? tr("%1 of %2 structures have a surface.").arg(builder_.total() - missing).arg(builder_.total())
                        : tr("Nothing is loaded."));
  QString html;
  if (document_.content().model) {
    for (const Structure& structure : document_.content().model->structures) {
      const QStringList lines = structureReport(structure).toHtmlEscaped().split('\n');
      html += "<p><b>" + lines.front() + "</b>";
      for (const QString& line : lines.mid(1)) {
        html += "<br>" + line;
      }
      html += "</p>";
    }
  }
  const int at = details_->verticalScrollBar()->value();
  details_->setHtml(html);
  details_->verticalScrollBar()->setValue(at);
}

}  // namespace glisson
