#include "app/gui/case_opener.h"

#include "app/gui/file_dialog.h"
#include "app/gui/label_dialog.h"
#include "app/gui/question_box.h"
#include "app/gui/reading_question.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

std::vector<std::filesystem::path> toPaths(const QStringList& texts) {
  std::vector<std::filesystem::path> paths;
  for (const QString& text : texts) {
    paths.emplace_back(text.toStdString());
  }
  return paths;
}

QStringList toTexts(const OpenRequest& request) {
  QStringList texts;
  for (const std::filesystem::path& path : request.paths) {
    texts << QString::fromStdString(path.string());
  }
  return texts;
}

}  // namespace

CaseOpener::CaseOpener(JobRunner& jobs, QWidget* dialogParent) : QObject(dialogParent), jobs_(jobs), dialogParent_(dialogParent) {
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId id) {
    if (opening_ == id) {
      opening_.reset();
    }
  });
}

void CaseOpener::openSample() {
  OpenRequest request;
  request.sample = true;
  start(request);
}

void CaseOpener::openPaths(const QStringList& paths) {
  OpenRequest request;
  request.paths = toPaths(paths);
  request.options = options_;
  if (opening_ && request.paths == openingPaths_) {
    return;  // a double click: the second one would find the file taken by the first
  }
  start(request);
}

void CaseOpener::start(const OpenRequest& request) {
  JobRequest job{.key = "open", .title = request.sample ? tr("Making the sample patient") : tr("Reading files")};
  job.fail = [this, request](const std::exception& error) { handleRefusal(request, error); };
  openingPaths_ = request.paths;
  opening_ = submitFor<OpenedCase>(
      jobs_, std::move(job), [request](const ExecutionContext& context) { return openInputs(request, context); },
      [this, request](OpenedCase result) { handle(request, std::move(result)); });
}

void CaseOpener::handle(const OpenRequest& request, OpenedCase result) {
  if (!result.loneCt.empty()) {
    const QString ct = QString::fromStdString(result.loneCt.string());
    if (unattended_) {
      emit refused(QStringLiteral("%1 holds a CT without a segmentation; open the CT and its segmentation together.").arg(ct));
    } else {
      askSegmentation(request, ct);
    }
    return;
  }
  if (!result.needsKinds()) {
    emit opened(result.content, result.file, toTexts(request), QString::fromStdString(result.noCt));
    return;
  }
  if (unattended_) {
    emit refused(QStringLiteral("%1 has the label %2 of unknown kind; name it with --labels.")
                     .arg(QString::fromStdString(request.readSoFar->segmentation->source),
                          QString::fromStdString(result.unknown.front().name)));
    return;
  }
  askKinds(request, result.unknown);
}

void CaseOpener::handleRefusal(const OpenRequest& request, const std::exception& error) {
  const bool mayAsk = dynamic_cast<const InputError*>(&error) != nullptr && !unattended_;
  const auto again = [this, request](const ReadOptions& answered) {
    OpenRequest next = request;
    next.options = answered;
    start(next);
  };
  if (!mayAsk || !askToRead(dialogParent_, messageOf(error), request.options, again)) {
    emit refused(messageOf(error));
  }
}

void CaseOpener::askSegmentation(const OpenRequest& request, const QString& ct) {
  const auto choose = [this, request](QFileDialog::FileMode mode) {
    return [this, request, mode] {
      QFileDialog* dialog = makeFileDialog(dialogParent_, "segmentationChoice", tr("Choose the segmentation of the CT"));
      dialog->setFileMode(mode);
      connect(dialog, &QFileDialog::fileSelected, this, [this, request](const QString& path) {
        rememberFolder({path});
        OpenRequest again = request;
        again.paths.emplace_back(path.toStdString());
        start(again);
      });
      dialog->open();
    };
  };
  ask(dialogParent_,
      {"segmentationDialog", tr("The segmentation of this CT"),
       tr("A CT alone makes no model. Choose the file or the folder that holds its segmentation."), ct},
      {{"segmentationFile", tr("A file..."), choose(QFileDialog::ExistingFile)},
       {"segmentationFolder", tr("A folder..."), choose(QFileDialog::Directory)}});
}

void CaseOpener::askKinds(const OpenRequest& request, const std::vector<LabelledMask>& unknown) {
  auto* dialog = new LabelDialog(unknown, request.readSoFar->segmentation->geometry, dialogParent_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, request] {
    OpenRequest again = request;
    again.options.labelTable = dialog->table();
    if (again.options.labelTable.empty()) {
      again.answeredKinds = dialog->chosen();
    } else {
      again.readSoFar->segmentation.reset();  // the reader names the labels by the table
    }
    start(again);
  });
  dialog->open();
}

}  // namespace glisson
