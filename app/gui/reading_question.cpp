#include "app/gui/reading_question.h"

#include <QCoreApplication>
#include <array>
#include <optional>
#include <utility>

#include "app/gui/question_box.h"
#include "app/gui/sentences.h"

namespace glisson {

namespace {

struct ReadingQuestion {
  Q_DECLARE_TR_FUNCTIONS(glisson::ReadingQuestion)
};

/// The consent that would let it pass.
std::optional<Consent> consentFor(const QString& refusal) {
  static constexpr std::array kFlags{
      std::pair{"resample-labels", Consent::ResampleLabels},
      std::pair{"uneven-slices", Consent::UnevenSlices},
      std::pair{"other-patient", Consent::OtherPatient},
      std::pair{"tilt", Consent::Tilt},
  };
  const qsizetype at = refusal.indexOf(QLatin1String("--accept"));
  for (const auto& [flag, consent] : kFlags) {
    if (at >= 0 && refusal.indexOf(QLatin1String(flag), at) >= 0) {
      return consent;
    }
  }
  return std::nullopt;
}

QString consequenceOf(Consent consent) {
  switch (consent) {
    case Consent::ResampleLabels:
      return ReadingQuestion::tr("The labels will be moved onto the CT's grid (nearest voxel). Borders may shift by half a voxel.");
    case Consent::Tilt:
      return ReadingQuestion::tr(
          "The CT was taken with a tilted gantry. It will be straightened by resampling; fine detail is softened.");
    case Consent::UnevenSlices:
      return ReadingQuestion::tr(
          "Slices are missing or unevenly spaced. The gaps will be filled by resampling: what lies in them is unseen.");
    case Consent::OtherPatient:
      return ReadingQuestion::tr(
          "CT and labels name different patients or studies. If they do not belong together, every number is wrong.");
  }
  return {};
}

}  // namespace

bool askToRead(QWidget* parent, const QString& refusal, const ReadOptions& options,
               const std::function<void(const ReadOptions&)>& again) {
  const QString title = ReadingQuestion::tr("A question before reading");
  if (options.niftiFrame == NiftiFrame::Agreeing && refusal.contains(QLatin1String("--prefer"))) {
    const auto use = [=](NiftiFrame frame) {
      return [=] {
        ReadOptions answered = options;
        answered.niftiFrame = frame;
        again(answered);
      };
    };
    ask(parent,
        {"frameDialog", title,
         ReadingQuestion::tr(
             "The file places its voxels in two ways that disagree (sform and qform). The wrong one moves or mirrors "
             "the liver. Choose the one your other programs use."),
         shownSentence(refusal)},
        {{"frameSform", ReadingQuestion::tr("Use sform"), use(NiftiFrame::SForm)},
         {"frameQform", ReadingQuestion::tr("Use qform"), use(NiftiFrame::QForm)}});
    return true;
  }
  const std::optional<Consent> consent = consentFor(refusal);
  if (!consent || options.consents.contains(*consent)) {
    return false;
  }
  const auto accept = [=] {
    ReadOptions answered = options;
    answered.consents.insert(*consent);
    again(answered);
  };
  ask(parent, {"consentDialog", title, consequenceOf(*consent), shownSentence(refusal)},
      {{"consentAccept", ReadingQuestion::tr("Read it all the same"), accept}});
  return true;
}

}  // namespace glisson
