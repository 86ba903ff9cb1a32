#pragma once
// Purpose: `plan --territories`: territories of the portal branches or segments, and what a plan takes from the remnant's blood.

#include "app/cli/command.h"
#include "planning/territories/territory_json.h"

namespace glisson::cli {

struct TerritoryFlags {
  bool wanted = false;
  bool confirm = false;
  std::vector<std::string> picks;  ///< NAME=BRANCH,BRANCH
  std::string segments;
  InputFlags input;  ///< how the map of segments is read
};
void addTerritoryFlags(CLI::App& command, TerritoryFlags& flags);
/// Throws UsageError where the flags contradict each other or cannot be read: called before anything is stored.
void checkTerritoryFlags(const TerritoryFlags& flags);

/// Computes everything of a case that does not depend on a plan. Throws UsageError, InputError.
class TerritoryCommand {
 public:
  TerritoryCommand(const Case& source, const TerritoryFlags& flags, const ExecutionContext& context);
  [[nodiscard]] TerritoryReport report(const ResectionPlan& plan) const;
  [[nodiscard]] const LiverPerfusion& perfusion() const { return perfusion_; }
  /// What the case is to keep: what the flags say, else what it held.
  [[nodiscard]] const TerritoryMarks& marks() const { return marks_; }
  /// What was done to them, as it stands behind Undo.
  [[nodiscard]] std::string editName() const;
  void printText(const TerritoryReport& report) const;

 private:
  LiverPerfusion perfusion_;
  Territories territories_;
  TerritoryMarks marks_;
  std::vector<std::string> notes_;
  std::vector<TumourTerritories> tumours_;
};

}  // namespace glisson::cli
