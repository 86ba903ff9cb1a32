#pragma once
// Purpose: `plan --accept-structure`: a person accepts structures of a case by name, or takes it back.

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "planning/case/case.h"

namespace glisson::cli {

struct AcceptanceFlags {
  std::vector<std::string> accept;  ///< ids, names, or all
  std::string by;
  std::vector<std::string> withdraw;  ///< likewise
};
void addAcceptanceFlags(CLI::App& command, AcceptanceFlags& flags);
/// Says what is wrong with the flags by themselves. Throws UsageError.
void checkAcceptanceFlags(const AcceptanceFlags& flags);

/// The case's model with what was asked for; the same one where nothing was. Throws UsageError.
std::shared_ptr<const LiverModel> accepted(const std::shared_ptr<const LiverModel>& model, const AcceptanceFlags& flags,
                                           const std::string& file);

void printAcceptance(const LiverModel& model);

}  // namespace glisson::cli
