#include "app/gui/start_options.h"

#include <QCommandLineParser>
#include <QRegularExpression>

#include "reconstruction/errors.h"

namespace glisson {

namespace {

void declare(QCommandLineParser& parser) {
  parser.setApplicationDescription("Glisson, planning of liver resections. Not for clinical use.");
  parser.addPositionalArgument("CASE|FILES", "A .glisson case, or a CT and its segmentation (files or folders).",
                               "[CASE|FILES...]");
  parser.addOptions({
      {{"h", "help"}, "Show this text and end."},
      {"version", "Show the version and end."},
      {"sample", "Open the built-in sample patient."},
      {"screenshot", "Build the model, write a picture of the window, and end.", "OUT.png"},
      {"pdf", "Build the model, write the report of a plan, and end.", "OUT.pdf"},
      {"plan", "The plan of --pdf and --screenshot; without it the first.", "NAME"},
      {"identity", "The report of --pdf names the patient: name, id, birth date, as far as the case holds them."},
      {"size", "Size of the window.", "WxH"},
      {"lang", "Language of the window: en or de.", "CODE"},
      {"labels", "Kinds of labels: totalsegmentator or N=KIND,NAME=KIND,...", "KINDS"},
      {"accept", "Consents: resample-labels,tilt,uneven-slices,other-patient.", "LIST"},
      {"prefer", "Where a NIfTI's two frames disagree: sform or qform.", "FRAME"},
  });
}

QSize parseSize(const QString& text) {
  static const QRegularExpression kPattern("^(\\d{3,5})x(\\d{3,5})$");
  const QRegularExpressionMatch match = kPattern.match(text);
  if (!match.hasMatch()) {
    throw UsageError("--size takes WIDTHxHEIGHT in pixels, for example 1440x900, not " + text.toStdString() + ".");
  }
  return {match.captured(1).toInt(), match.captured(2).toInt()};
}

}  // namespace

StartOptions parseStartOptions(const QStringList& arguments) {
  QCommandLineParser parser;
  declare(parser);
  if (!parser.parse(QStringList{"glisson"} + arguments)) {
    throw UsageError(parser.errorText().toStdString() + " Ask glisson --help.");
  }
  StartOptions options;
  options.paths = parser.positionalArguments();
  options.help = parser.isSet("help");
  options.version = parser.isSet("version");
  options.sample = parser.isSet("sample");
  options.screenshot = parser.value("screenshot");
  options.pdf = parser.value("pdf");
  if (options.sample && !options.paths.isEmpty()) {
    throw UsageError("--sample opens the sample patient and takes no files; leave one of them out.");
  }
  if (parser.isSet("screenshot") && (options.screenshot.isEmpty() || (!options.sample && options.paths.isEmpty()))) {
    throw UsageError("--screenshot needs the name of a PNG and something to show: a case, files, or --sample.");
  }
  if (parser.isSet("pdf") && (options.pdf.isEmpty() || (!options.sample && options.paths.isEmpty()))) {
    throw UsageError("--pdf needs the name of a PDF and something to report: a case, files, or --sample.");
  }
  options.plan = parser.value("plan");
  if (parser.isSet("plan") && (options.plan.isEmpty() || (options.pdf.isEmpty() && options.screenshot.isEmpty()))) {
    throw UsageError("--plan names the plan of --pdf or --screenshot; give one of them and a name, or leave --plan out.");
  }
  options.identity = parser.isSet("identity");
  if (options.identity && options.pdf.isEmpty()) {
    throw UsageError("--identity is about the report of --pdf; name its file or leave --identity out.");
  }
  if (parser.isSet("size")) {
    options.size = parseSize(parser.value("size"));
  }
  options.language = parser.value("lang");
  if (parser.isSet("lang") && options.language != "en" && options.language != "de") {
    throw UsageError("--lang takes en or de, not " + options.language.toStdString() + ".");
  }
  if (parser.isSet("labels")) {
    parseLabels(parser.value("labels").toStdString(), options.read);
  }
  if (parser.isSet("accept")) {
    parseConsents(parser.value("accept").toStdString(), options.read);
  }
  if (parser.isSet("prefer")) {
    const QString frame = parser.value("prefer");
    if (frame != "sform" && frame != "qform") {
      throw UsageError("--prefer takes sform or qform, not " + frame.toStdString() + ".");
    }
    options.read.niftiFrame = frame == "sform" ? NiftiFrame::SForm : NiftiFrame::QForm;
  }
  return options;
}

QString usageText() {
  QCommandLineParser parser;
  declare(parser);
  return parser.helpText();
}

}  // namespace glisson
