#include "app/gui/case_opener.h"

#include "app/gui/file_dialog.h"
#include "app/gui/label_dialog.h"
#include "app/gui/question_box.h"
#include "app/gui/sentences.h"
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

QString consequenceOf(Consent consent) {
  switch (consent) {
    case Consent::ResampleLabels:
      return CaseOpener::tr("The labels will be moved onto the CT's grid (nearest voxel). Borders may shift by half a voxel.");
    case Consent::Tilt:
      return CaseOpener::tr(
          "The CT was taken with a tilted gantry. It will be straightened by resampling; fine detail is softened.");
    case Consent::UnevenSlices:
      return CaseOpener::tr(
          "Slices are missing or unevenly spaced. The gaps will be filled by resampling: what lies in them is unseen.");
    case Consent::OtherPatient:
      return CaseOpener::tr(
          "CT and labels name different patients or studies. If they do not belong together, every number is wrong.");
  }
  return {};
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
  const bool input = dynamic_cast<const InputError*>(&error) != nullptr;
  const std::optional<ConsentQuestion> question = input && !unattended_ ? questionOf(error.what()) : std::nullopt;
  const bool askedBefore = question && question->consent && request.options.consents.contains(*question->consent);
  if (!question || askedBefore) {
    emit refused(messageOf(error));
  } else if (question->consent) {
    askConsent(request, *question->consent, messageOf(error));
  } else {
    askFrame(request, messageOf(error));
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

void CaseOpener::askConsent(const OpenRequest& request, Consent consent, const QString& refusal) {
  const auto accept = [this, request, consent] {
    OpenRequest again = request;
    again.options.consents.insert(consent);
    start(again);
  };
  ask(dialogParent_, {"consentDialog", tr("A question before reading"), consequenceOf(consent), shownSentence(refusal)},
      {{"consentAccept", tr("Read it all the same"), accept}});
}

void CaseOpener::askFrame(const OpenRequest& request, const QString& refusal) {
  const auto use = [this, request](NiftiFrame frame) {
    return [this, request, frame] {
      OpenRequest again = request;
      again.options.niftiFrame = frame;
      start(again);
    };
  };
  ask(dialogParent_,
      {"frameDialog", tr("A question before reading"),
       tr("The file places its voxels in two ways that disagree (sform and qform). The wrong one moves or mirrors "
          "the liver. Choose the one your other programs use."),
       shownSentence(refusal)},
      {{"frameSform", tr("Use sform"), use(NiftiFrame::SForm)}, {"frameQform", tr("Use qform"), use(NiftiFrame::QForm)}});
}

}  // namespace glisson
