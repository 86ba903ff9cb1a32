#include "app/cli/command.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <iostream>
#include <system_error>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

void addInputFlags(CLI::App& command, InputFlags& flags) {
  command.add_option("--labels", flags.labels,
                     "What the labels mean: totalsegmentator, totalsegmentator-v1, totalsegmentator-mr, or N=KIND,NAME=KIND,...");
  command.add_option("--accept", flags.accept,
                     "Accept a doubtful input: resample-labels,tilt,uneven-slices,other-patient (comma separated)");
  command.add_option("--prefer", flags.prefer, "Where a NIfTI file's two frames differ: sform or qform");
}

ReadOptions readOptions(const InputFlags& flags) {
  ReadOptions options;
  if (!flags.labels.empty()) {
    parseLabels(flags.labels, options);
  }
  if (!flags.accept.empty()) {
    parseConsents(flags.accept, options);
  }
  if (flags.prefer == "sform") {
    options.niftiFrame = NiftiFrame::SForm;
  } else if (flags.prefer == "qform") {
    options.niftiFrame = NiftiFrame::QForm;
  } else if (!flags.prefer.empty()) {
    throw UsageError("--prefer takes sform or qform, not \"" + flags.prefer + "\"");
  }
  return options;
}

CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, const std::string& description) {
  return command
      .add_option_function<std::string>(
          name,
          [name, &value](const std::string& text) {
            const auto number = parseNumber(text);
            if (!number) {
              throw CLI::ValidationError(name, "takes a number, not \"" + text + "\"");
            }
            value = *number;
          },
          description)
      ->default_str(formatExact(value));
}

CLI::Option* addInteger(CLI::App& command, const std::string& name, int& value, const std::string& description) {
  return command
      .add_option_function<std::string>(
          name,
          [name, &value](const std::string& text) {
            const auto number = parseInteger(text);
            if (!number || *number != static_cast<int>(*number)) {
              throw CLI::ValidationError(name, "takes a whole number, not \"" + text + "\"");
            }
            value = static_cast<int>(*number);
          },
          description)
      ->default_str(std::to_string(value));
}

void checkWritable(const std::filesystem::path& path) {
  std::error_code error;
  if (path.filename().empty() || std::filesystem::is_directory(path, error)) {
    throw UsageError(path.string() + " is a folder; name the file to write");
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error)) {
    throw InputError(path.string() + " cannot be written: the folder " + folder.string() + " does not exist; make it first");
  }
}

namespace {
std::atomic<bool> progressShown{false};
}  // namespace

void showProgress(int percent, std::string_view phase) {
  progressShown = true;
  std::cerr << "\r\033[K" << percent << " % " << phase << std::flush;
}

void clearProgress() {
  if (progressShown.exchange(false)) {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void complain(const std::string& sentence) {
  clearProgress();
  std::string line = sentence;
  for (char& c : line) {
    if (c == '\n' || c == '\r') {
      c = ' ';
    }
  }
  const bool ended = line.ends_with('.') || line.ends_with('!') || line.ends_with('?');
  std::cerr << "glisson-cli: " << line << (ended ? "" : ".") << std::endl;
}

}  // namespace glisson::cli
