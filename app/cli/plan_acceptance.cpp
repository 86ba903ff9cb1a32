#include "app/cli/plan_acceptance.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "reconstruction/errors.h"

namespace glisson::cli {

namespace {
/// Ids of what `wanted` names: an id, a name that stands once, or all.
std::vector<std::string> idsOf(const std::string& flag, const std::vector<std::string>& wanted, const LiverModel& model,
                               const std::string& file) {
  std::vector<std::string> ids;
  for (const std::string& name : wanted) {
    std::vector<std::string> found;
    std::string known;
    for (const Structure& structure : model.structures) {
      if (name == "all" || structure.id == name || (structure.name == name && model.find(name) == nullptr)) {
        found.push_back(structure.id);
      }
      known += (known.empty() ? "" : ", ") + structure.id;
    }
    if (found.empty() || (name != "all" && found.size() > 1)) {
      throw UsageError(flag + " " + name + " is not in " + file + " or stands for several; it holds: " + known);
    }
    ids.insert(ids.end(), found.begin(), found.end());
  }
  return ids;
}
}  // namespace

void addAcceptanceFlags(CLI::App& command, AcceptanceFlags& flags) {
  command.add_option("--accept-structure", flags.accept, "A structure's id or name, or all: --accepted-by has looked at it")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--accepted-by", flags.by, "The name of the person who accepts the structures of --accept-structure");
  command.add_option("--withdraw-acceptance", flags.withdraw, "A structure's id or name, or all: nobody accepts it any more")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void checkAcceptanceFlags(const AcceptanceFlags& flags) {
  if (flags.accept.empty() != flags.by.empty()) {
    throw UsageError("--accept-structure and --accepted-by belong together: what is accepted, and the name of the person");
  }
  if (!flags.by.empty()) {
    try {
      (void)acceptedNow(flags.by);
    } catch (const PlanningError& error) {
      throw UsageError(std::string("--accepted-by: ") + error.what());
    }
  }
}

std::shared_ptr<const LiverModel> accepted(const std::shared_ptr<const LiverModel>& model, const AcceptanceFlags& flags,
                                           const std::string& file) {
  std::shared_ptr<const LiverModel> changed = model;
  try {
    if (!flags.withdraw.empty()) {
      changed = withAcceptance(*changed, idsOf("--withdraw-acceptance", flags.withdraw, *changed, file), std::nullopt);
    }
    if (!flags.accept.empty()) {
      changed = withAcceptance(*changed, idsOf("--accept-structure", flags.accept, *changed, file), acceptedNow(flags.by));
    }
  } catch (const PlanningError& error) {
    throw UsageError(error.what());  // what was typed does not fit this case
  }
  return changed;
}

void printAcceptance(const LiverModel& model) {
  std::string open;
  for (const Structure& structure : model.structures) {
    if (structure.acceptance) {
      std::cout << "accepted: " << structure.id << " by " << structure.acceptance->by << ", " << structure.acceptance->at << '\n';
    } else {
      open += (open.empty() ? "" : ", ") + structure.id;
    }
  }
  if (!open.empty()) {
    std::cout << "not accepted by anybody: " << open << '\n';
  }
}

}  // namespace glisson::cli
