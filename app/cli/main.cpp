// Purpose: glisson-cli: parses the command line, runs one command, turns every exception into one line and an exit code.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <clocale>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <streambuf>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "planning/exchange/version.h"
#include "reconstruction/errors.h"

namespace glisson::cli {
namespace {

/// Progress on stderr where a person looks at it; silence in scripts and logs.
ExecutionContext progressOnTerminal() {
  if (isatty(STDERR_FILENO) == 0) {
    return {};
  }
  return ExecutionContext([percent = -1](double fraction, std::string_view phase) mutable {
    const int now = static_cast<int>(100.0 * fraction);
    if (now != percent) {
      percent = now;
      showProgress(now, phase);
    }
  });
}

/// While it lives, std::cout takes the line of progress away before anything stands beside it.
class BesideProgress : public std::streambuf {
 public:
  BesideProgress() : to_(std::cout.rdbuf(this)) {}
  ~BesideProgress() override { std::cout.rdbuf(to_); }
  BesideProgress(const BesideProgress&) = delete;
  BesideProgress& operator=(const BesideProgress&) = delete;

 private:
  int_type overflow(int_type c) override {
    clearProgress();
    return traits_type::eq_int_type(c, traits_type::eof()) ? traits_type::not_eof(c) : to_->sputc(traits_type::to_char_type(c));
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    clearProgress();
    return to_->sputn(text, size);
  }
  int sync() override { return to_->pubsync(); }

  std::streambuf* to_;
};

int failed(int code, const std::string& sentence) {
  complain(sentence);
  return code;
}

int run(const Action& action) {
  const ExecutionContext context = progressOnTerminal();
  const InterruptCancels interrupt(context);
  const BesideProgress output;
  try {
    const int code = action(context);
    std::cout.flush();
    if (!std::cout) {
      return failed(kInput, "the output cannot be written to stdout");
    }
    return code;
  } catch (const Cancelled&) {
    return failed(kInterrupted, "interrupted; nothing was written");
  } catch (const UsageError& error) {
    return failed(kUsage, error.what());
  } catch (const CheckFailed& error) {
    return failed(kCheckFailed, error.what());
  } catch (const Error& error) {
    return failed(kInput, error.what());
  } catch (const std::bad_alloc&) {
    return failed(kInput, kOutOfMemory);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(kInput, error.what());
  } catch (const std::exception& error) {
    return failed(kInput, std::string("unexpected failure: ") + error.what());
  }
}

/// CLI11 says of a word that is no command only that a command is missing.
std::string usageSentence(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining();
  const bool noCommand = app.get_subcommands().empty() && !unknown.empty();
  return (noCommand ? "there is no command " + unknown.front() : std::string(error.what())) + "; see glisson-cli --help";
}

int parseAndRun(int argc, char** argv) {
  CLI::App app("Glisson: planning of liver resections from the command line. Not for clinical use.", "glisson-cli");
  app.set_version_flag("--version", "glisson-cli " + std::string(glissonVersion()));
  app.set_help_all_flag("--help-all", "Help of every command");
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done; 2 wrong usage; 3 input unreadable or refused; 4 computed, but a check failed; 130 interrupted.");
  Action chosen;
  addSample(app, chosen);
  addInfo(app, chosen);
  addReconstruct(app, chosen);
  addMeasure(app, chosen);
  addEvaluate(app, chosen);
  addModel(app, chosen);
  addPlan(app, chosen);
  addExport(app, chosen);
  addVerify(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app.exit(error);  // --help, --version: on stdout
    }
    return failed(kUsage, usageSentence(app, error));
  }
  return run(chosen);
}

}  // namespace
}  // namespace glisson::cli

int main(int argc, char** argv) {
  std::setlocale(LC_ALL, "C");
  try {
    return glisson::cli::parseAndRun(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glisson-cli: unexpected failure: %s\n", error.what());
    return glisson::cli::kInput;
  }
}
