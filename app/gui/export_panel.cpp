#include "app/gui/export_panel.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/model_builder.h"
#include "app/gui/question_box.h"
#include "app/gui/sentences.h"
#include "planning/exchange/package.h"

namespace glisson {

ExportPanel::ExportPanel(Document& document, JobRunner& jobs, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      jobs_(jobs),
      export_(new QPushButton(this)),
      plan_(new QLabel(this)),
      contents_(new QLabel(this)),
      stl_(new QCheckBox(this)),
      glb_(new QCheckBox(this)),
      patientId_(new QCheckBox(this)),
      deviations_(new QLabel(this)),
      notAccepted_(new QLabel(this)),
      result_(new QLabel(this)) {
  setObjectName("exportPanel");
  export_->setObjectName("exportPackage");
  stl_->setObjectName("exportStl");
  glb_->setObjectName("exportGlb");
  patientId_->setObjectName("exportPatientId");
  notAccepted_->setObjectName("exportNotAccepted");
  result_->setObjectName("exportResult");
  plan_->setObjectName("exportPlan");
  stl_->setChecked(true);
  glb_->setChecked(true);
  for (QLabel* label : {plan_, contents_, deviations_, notAccepted_, result_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  for (QWidget* part :
       std::initializer_list<QWidget*>{export_, plan_, contents_, stl_, glb_, patientId_, deviations_, notAccepted_, result_}) {
    column->addWidget(part);
  }
  column->addStretch(1);
  connect(export_, &QPushButton::clicked, this, &ExportPanel::startExport);
  for (QCheckBox* box : {stl_, glb_}) {
    connect(box, &QCheckBox::toggled, this, &ExportPanel::refresh);
  }
  connect(&document_, &Document::caseChanged, this, [this] {
    lastFolder_.clear();
    refresh();
  });
  connect(&document_, &Document::modelChanged, this, &ExportPanel::markOutOfDate);
  connect(&document_, &Document::planChanged, this, &ExportPanel::markOutOfDate);
  retranslateUi();
}

void ExportPanel::retranslateUi() {
  export_->setText(tr("Export package..."));
  contents_->setText(
      tr("A folder for navigation: the structures, the remnant, the resected part and the resection surface, with plan.json and a "
         "manifest. Every file is read back and compared before it counts as exported. Millimetres, LPS."));
  stl_->setText(tr("STL, one file per structure"));
  glb_->setText(tr("GLB, one file with colours"));
  patientId_->setText(tr("Write the patient's id into plan.json"));
  patientId_->setToolTip(tr("Otherwise nothing in the package names the patient."));
  refresh();
}

QStringList ExportPanel::deviations() const {
  QStringList texts;
  if (document_.content().model) {
    for (const Structure& structure : document_.content().model->structures) {
      if (structure.reconstruction) {
        for (const std::string& deviation : structure.reconstruction->deviations) {
          texts << structureName(structure) + QStringLiteral(": ") + shownSentence(deviation);
        }
      }
    }
  }
  return texts;
}

QString ExportPanel::refusal() const {
  if (!document_.isOpen()) {
    return QStringLiteral("Open a case first.");
  }
  for (const Structure& structure : document_.content().model->structures) {
    if (isModelled(structure) && !structure.reconstruction) {
      return QStringLiteral("%1 has no surface yet.")
          .arg(QString::fromStdString(structure.name.empty() ? structure.id : structure.name));
    }
  }
  if (!stl_->isChecked() && !glb_->isChecked()) {
    return QStringLiteral("Choose a format.");
  }
  return {};
}

void ExportPanel::refresh() {
  const QString reason = refusal();
  export_->setEnabled(reason.isEmpty());
  export_->setToolTip(reason.isEmpty() ? tr("Writes the navigation package (Ctrl+E)") : shownSentence(reason));
  plan_->setVisible(document_.isOpen());
  plan_->setText(tr("Plan: %1").arg(shownName(document_.plan().name)));
  const QStringList found = deviations();
  deviations_->setVisible(!found.isEmpty());
  deviations_->setText(tr("These structures deviate from their voxels; you will be asked before they are exported:") + '\n' +
                       found.join('\n'));
  QStringList open;
  if (document_.content().model) {
    for (const std::string& id : notAccepted(*document_.content().model)) {
      open << structureName(*document_.content().model->find(id));
    }
  }
  notAccepted_->setVisible(!open.isEmpty());
  notAccepted_->setText(tr("Nobody has accepted these structures; the package says so: %1").arg(open.join(QStringLiteral(", "))));
  const QString folder = QDir::toNativeSeparators(lastFolder_);
  result_->setText(lastFolder_.isEmpty() ? QString()
                   : outOfDate_          ? tr("Out of date, exported before the last change: %1").arg(folder)
                                         : tr("Exported and verified: %1").arg(folder));
}

void ExportPanel::markOutOfDate() {
  ++changes_;
  outOfDate_ = true;
  refresh();
}

QString ExportPanel::stateText() const {
  if (lastFolder_.isEmpty()) {
    return tr("not exported");
  }
  return outOfDate_ ? tr("out of date") : tr("exported");
}

void ExportPanel::startExport() {
  if (!refusal().isEmpty()) {
    emit exportFailed(refusal());
    return;
  }
  auto* dialog =
      new QFileDialog(this, tr("Folder for the package"), QSettings().value("exportFolder", QDir::homePath()).toString());
  dialog->setObjectName("exportFolderDialog");
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // queued: the key that accepted the folder must not answer the question that may follow
  connect(dialog, &QFileDialog::fileSelected, this, &ExportPanel::exportTo, Qt::QueuedConnection);
  dialog->open();
}

void ExportPanel::exportTo(const QString& directory) {
  QSettings().setValue("exportFolder", directory);
  const QStringList found = deviations();
  if (found.isEmpty()) {
    write(directory, false);
    return;
  }
  ask(this,
      {"deviationDialog", tr("Structures deviate"),
       tr("The surfaces of these structures differ from their voxels more than they should. A navigation system "
          "would show them as they are."),
       found.join('\n')},
      {{"deviationAccept", tr("Export all the same"), [this, directory] { write(directory, true); }}});
}

void ExportPanel::write(const QString& directory, bool acceptDeviations) {
  ExportOptions options;
  options.planName = document_.plan().name;
  options.stl = stl_->isChecked();
  options.glb = glb_->isChecked();
  options.patientId = patientId_->isChecked();
  options.acceptDeviations = acceptDeviations;
  JobRequest request{.key = "export", .title = tr("Export")};
  request.fail = [this](const std::exception& error) { emit exportFailed(messageOf(error)); };
  submitFor<ExportResult>(
      jobs_, std::move(request),
      [content = document_.content(), directory = directory.toStdString(), options](const ExecutionContext& context) {
        return exportPackage(content, directory, options, context);
      },
      [this, changes = changes_](const ExportResult& result) {
        lastFolder_ = QString::fromStdString(result.folder.string());
        outOfDate_ = changes_ != changes;  // edited while it was written
        refresh();
        emit exported(lastFolder_);
      });
}

}  // namespace glisson
