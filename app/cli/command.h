#pragma once
// Purpose: what the commands of glisson-cli have in common: how they are registered, run and end, and the flags they share.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "reconstruction/execution_context.h"
#include "reconstruction/io/read.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace glisson::cli {

/// The exit codes of the command line (design contract; README "The command line").
enum ExitCode : int { kDone = 0, kUsage = 2, kInput = 3, kCheckFailed = 4, kInterrupted = 130 };

/// One command after its arguments are parsed. Returns an exit code; throws Error or Cancelled.
using Action = std::function<int(const ExecutionContext&)>;

/// Each adds one subcommand to `app`; when the user asks for it, `chosen` becomes its action.
void addSample(CLI::App& app, Action& chosen);
void addInfo(CLI::App& app, Action& chosen);
void addReconstruct(CLI::App& app, Action& chosen);
void addMeasure(CLI::App& app, Action& chosen);
void addEvaluate(CLI::App& app, Action& chosen);
void addModel(CLI::App& app, Action& chosen);
void addPlan(CLI::App& app, Action& chosen);
void addExport(CLI::App& app, Action& chosen);
void addVerify(CLI::App& app, Action& chosen);

/// Said of std::bad_alloc.
inline constexpr const char* kOutOfMemory = "the memory does not suffice; close other programs, lower --depth or crop the input";

/// --labels, --accept, --prefer as given.
struct InputFlags {
  std::string labels;
  std::string accept;
  std::string prefer;
};
void addInputFlags(CLI::App& command, InputFlags& flags);
/// Throws UsageError.
ReadOptions readOptions(const InputFlags& flags);

/// An option that takes a number; '.' is the decimal sign in every locale, "inf" and "nan" are refused.
CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, const std::string& description);
CLI::Option* addInteger(CLI::App& command, const std::string& name, int& value, const std::string& description);

/// Throws InputError where the folder that is to hold `path` is missing, UsageError where `path` is a folder: said before the work
/// is done, not after.
void checkWritable(const std::filesystem::path& path);
/// A line on stderr that the next one or clearProgress() takes away.
void showProgress(int percent, std::string_view phase);
void clearProgress();
/// One line on stderr: "glisson-cli: ...", in the place of the progress.
void complain(const std::string& sentence);

}  // namespace glisson::cli
