// The part of MainWindow that deals with files: dialogs, drops, saving, closing, and the about box.

#include <QCloseEvent>
#include <QCoreApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QMessageBox>
#include <QMimeData>

#include "app/gui/file_dialog.h"
#include "app/gui/job_bar.h"
#include "app/gui/main_window.h"
#include "app/gui/message_bar.h"
#include "app/gui/number_text.h"
#include "app/gui/question_box.h"
#include "app/gui/report_writer.h"
#include "app/gui/territory_estimator.h"
#include "app/gui/view_area.h"
#include "planning/storage/embedded_ct.h"
#include "reconstruction/errors.h"

namespace glisson {

void MainWindow::openFiles() {
  QFileDialog* dialog = makeFileDialog(this, "openDialog", tr("Open a CT with its segmentation, or a case"));
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setNameFilters({tr("Images and cases (*.glisson *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.dcm)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
    rememberFolder(paths);
    opener_->openPaths(paths);
  });
  dialog->open();
}

void MainWindow::openFolder() {
  QFileDialog* dialog = makeFileDialog(this, "openFolderDialog", tr("Open a folder that holds a CT and its segmentation"));
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
    rememberFolder(paths);
    opener_->openPaths(paths);
  });
  dialog->open();
}

void MainWindow::save() {
  if (document_->isRecovery() || document_->isReadOnly()) {
    saveAs();
  } else {
    document_->save();
  }
}

void MainWindow::saveAs() {
  if (!document_->isOpen()) {
    return;
  }
  QFileDialog* dialog = makeFileDialog(this, "saveDialog", tr("Save the case"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Glisson cases (*.glisson)"));
  dialog->setDefaultSuffix("glisson");
  dialog->selectFile(QString::fromStdString(document_->content().code) + ".glisson");
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    rememberFolder({path});
    document_->saveAs(path.toStdString());
  });
  dialog->open();
}

void MainWindow::saveCopyWithCt() {
  const std::shared_ptr<const CtVolume> ct = document_->content().ct;
  if (!ct) {
    return;
  }
  constexpr double kBytesPerMb = 1e6;
  const double megabytes = static_cast<double>(embeddedCtBytes(*ct)) / kBytesPerMb;
  const auto choose = [this] {
    QFileDialog* dialog = makeFileDialog(this, "saveCopyDialog", tr("Save a copy with the CT"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Glisson cases (*.glisson)"));
    dialog->setDefaultSuffix("glisson");
    dialog->selectFile(QString::fromStdString(document_->content().code) + "-ct.glisson");
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
      rememberFolder({path});
      document_->saveCopyWithCt(path.toStdString());
    });
    dialog->open();
  };
  const Index3& size = ct->geometry.size;
  ask(this,
      {"embedDialog", tr("Save a copy with the CT"),
       tr("The CT of %1 x %2 x %3 voxels adds about %4 MB to the copy.")
           .arg(QString::number(size[0]), QString::number(size[1]), QString::number(size[2]), numberText(megabytes, 1)),
       tr("Whoever gets the file sees the slices, and the patient's name, id and birth date where the case holds them.")},
      {{"embedAccept", tr("Choose the file..."), choose}});
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) {
      paths << url.toLocalFile();
    }
  }
  if (!paths.isEmpty()) {
    event->acceptProposedAction();
    opener_->openPaths(paths);
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  document_->flush();  // every edit is in the case's file then, and there is nothing to ask
  if (document_->keepsAll() || losesEdits_) {
    event->accept();
    return;
  }
  event->ignore();
  const auto lose = [this] {
    losesEdits_ = true;
    close();
  };
  ask(this,
      {"lostEditsDialog", tr("Changes are not on disk"), tr("The last changes could not be written and go with the window."),
       QDir::toNativeSeparators(QString::fromStdString(document_->path().string()))},
      {{"lostEditsSave", tr("Save under another name..."), [this] { saveAs(); }},
       {"lostEditsClose", tr("Close and lose them"), lose}});
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Glisson"), QString(), QMessageBox::Ok, this);
  box->setObjectName("aboutDialog");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setIconPixmap(QIcon(":/icons/glisson.svg").pixmap(64, 64));
  box->setText(tr("Glisson %1").arg(QCoreApplication::applicationVersion()));
  box->setInformativeText(
      tr("Planning of liver resections: the parenchyma by Poisson surface reconstruction, vessels and tumours by "
         "marching cubes.\n\nNot for clinical use: this is no medical device. Check every number before you "
         "rely on it."));
  box->open();
}

void MainWindow::saveReport(bool withIdentity) {
  const QString code = QString::fromStdString(document_->content().code);
  const QString path = QFileDialog::getSaveFileName(this, tr("Report as PDF"), code + QStringLiteral(".pdf"), tr("PDF (*.pdf)"));
  if (path.isEmpty()) {
    return;
  }
  try {
    writeReport(path, withIdentity);
  } catch (const Error& error) {
    complain(messageOf(error));
  }
}

void MainWindow::writeReport(const QString& path, bool withIdentity) {
  if (!document_->isOpen() || document_->freshness() != Freshness::All) {
    throw PlanningError("The plan's numbers are still being computed; try again in a moment.");
  }
  PlanReport report{.content = document_->content(),
                    .plan = document_->plan(),
                    .assessment = document_->assessment(),
                    .withIdentity = withIdentity};
  if (const TerritoryReport* territories = territories_->report()) {
    report.territories = *territories;
  }
  reports_->write(std::move(report), document_->tumourDistance(), views_->displayMeshes(), path);
}

}  // namespace glisson
