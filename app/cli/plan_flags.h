#pragma once
// Purpose: what `glisson-cli plan` is asked for, as text, and what its parts mean. Throws UsageError naming the flag.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/plan_acceptance.h"
#include "app/cli/plan_territories.h"
#include "planning/case/case.h"

namespace glisson::cli {

struct PlanFlags {
  std::string caseFile;
  std::string plan;  ///< empty: the first
  // planes of one resection
  std::vector<std::string> planes;
  std::vector<std::string> points;
  std::vector<std::string> lines;
  std::vector<std::string> slices;
  std::string proposeMargin;  ///< a tumour
  bool flip = false;
  std::string bend;         ///< of the last of them
  std::string toResection;  ///< empty: a new one
  // planes that are there
  std::vector<std::string> bendPlanes;
  std::vector<std::string> flattenPlanes;
  // other edits of the plan
  std::string removeResection;
  std::string margin;
  std::vector<std::string> islands;
  std::vector<std::string> measures;
  // the list of plans
  std::string duplicate;
  std::string rename;
  bool remove = false;
  std::vector<std::string> compare;
  // the patient
  std::string height;
  std::string weight;
  std::string condition;
  std::string tumourType;

  AcceptanceFlags acceptance;
  TerritoryFlags territories;
  bool dryRun = false;
  bool json = false;
};

void addPlanFlags(CLI::App& command, PlanFlags& flags);

/// Says what is wrong with the flags by themselves, before a file is opened.
void checkFlags(const PlanFlags& flags);

/// The planes asked for but for --propose-margin, in the order --plane, --points, --line, --slice; `flip` turns them around.
std::vector<HalfSpace> planesOf(const PlanFlags& flags, const ImageGeometry& geometry);
/// h0,...,h15[,halfSize]
struct TypedBend {
  std::array<double, 16> heightsMm{};
  std::optional<double> halfSizeMm;
};
TypedBend bendOf(const std::string& text);
/// A plane that is there, counted from 0, and its bend: N,h0,...,h15[,halfSize], N counted from 1.
struct TypedPlaneBend {
  std::size_t plane = 0;
  TypedBend bend;
};
TypedPlaneBend planeBendOf(const std::string& text);
/// A plane's number, counted from 0, out of one that counts from 1.
std::size_t planeNumberOf(const std::string& flag, const std::string& text);
/// x,y,z,resected or x,y,z,remnant
IslandAssignment islandOf(const std::string& text);
/// x,y,z,x,y,z
Measure measureOf(const std::string& text);
/// A number of `flag`.
double numberOf(const std::string& flag, const std::string& text);
/// `before` with what is given; "none" forgets a fact.
PatientFacts factsOf(const PlanFlags& flags, const PatientFacts& before);

}  // namespace glisson::cli
