#include "app/cli/plan_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "planning/resection/place_plane.h"
#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::cli {

namespace {
std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    parts.push_back(part);
  }
  return parts;
}

/// `count` numbers; `form` says what they are.
std::vector<double> numbersOf(const std::string& flag, const std::string& text, std::size_t count, const std::string& form) {
  const std::vector<std::string> parts = partsOf(text);
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = parseNumber(part);
    if (!number) {
      throw UsageError(flag + " " + text + ": \"" + part + "\" is no number");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() != count) {
    throw UsageError(flag + " takes " + form + ", not \"" + text + "\"");
  }
  return numbers;
}

Vec3 pointAt(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

HalfSpace typedPlane(const std::string& text) {
  const auto numbers = numbersOf("--plane", text, 6, "six numbers ox,oy,oz,nx,ny,nz");
  const Vec3 normal = pointAt(numbers, 3);
  if (!(normal.norm() > 0)) {
    throw UsageError("--plane " + text + ": the normal has no length");
  }
  return {pointAt(numbers, 0), normal.normalized()};
}

HalfSpace slicePlane(const std::string& text, const ImageGeometry& geometry) {
  const std::size_t comma = text.find(',');
  for (const SlicePlane slice : {SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal}) {
    if (comma != std::string::npos && text.substr(0, comma) == idOf(slice)) {
      const auto numbers = numbersOf("--slice", text.substr(comma + 1), 3, "axial, coronal or sagittal and a point x,y,z");
      return planeParallelToSlice(geometry, slice, pointAt(numbers, 0));
    }
  }
  throw UsageError("--slice takes axial, coronal or sagittal and a point x,y,z, not \"" + text + "\"");
}

/// A gesture that gives no plane is wrong usage here: the numbers were typed.
template <typename Place>
HalfSpace placed(const std::string& flag, const std::string& text, Place&& place) {
  try {
    return place();
  } catch (const PlanningError& error) {
    throw UsageError(flag + " " + text + ": " + error.what());
  }
}

std::optional<double> factOf(const std::string& flag, const std::string& text, std::optional<double> before) {
  if (text.empty()) {
    return before;
  }
  return text == "none" ? std::nullopt : std::optional(numberOf(flag, text));
}

void addMany(CLI::App& command, const std::string& name, std::vector<std::string>& values, const std::string& description) {
  command.add_option(name, values, description)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}
}  // namespace

void addPlanFlags(CLI::App& command, PlanFlags& flags) {
  command.add_option("CASE", flags.caseFile, "The .glisson case")->required();
  addMany(command, "--plane", flags.planes,
          "ox,oy,oz,nx,ny,nz: a point (mm LPS) and the direction to the resected side; several bound one resection together; "
          "none: only the assessment");
  addMany(command, "--points", flags.points,
          "x,y,z,x,y,z,x,y,z: the plane through three points; the side they are counter-clockwise from is resected");
  addMany(command, "--line", flags.lines,
          "x,y,z,x,y,z,dx,dy,dz: a line drawn from one point to the other, seen along a direction; its right is resected");
  addMany(command, "--slice", flags.slices,
          "axial|coronal|sagittal,x,y,z: parallel to a slice view; the superior, posterior or left side is resected");
  command.add_option("--propose-margin", flags.proposeMargin,
                     "A tumour's id or name: the plane with the smallest functional volume that keeps the safety margin around it");
  command.add_flag("--flip", flags.flip, "The other side of the planes of this call is resected (not of --propose-margin)");
  command.add_option(
      "--bend", flags.bend,
      "h0,...,h15[,halfSize]: bend the last placed plane of this call; 16 heights along its normal, mm, row by row over a "
      "square around its origin (halfSize mm; without it: over the cut)");
  command.add_option(
      "--resection", flags.toResection,
      "Add the planes to this resection instead of making a new one; the resection of --bend-plane and --flatten-plane");
  addMany(command, "--bend-plane", flags.bendPlanes,
          "N,h0,...,h15[,halfSize]: bend plane N (from 1) of --resection, or of the only one, as --bend does; one that is bent "
          "keeps its "
          "square but for the half size");
  addMany(command, "--flatten-plane", flags.flattenPlanes,
          "N: make bent plane N (from 1) of --resection, or of the only one, flat");
  command.add_option("--remove-resection", flags.removeResection, "Remove this resection from the plan");
  command.add_option("--margin", flags.margin, "The plan's safety margin, mm");
  addMany(command, "--island", flags.islands,
          "x,y,z,resected|remnant|back: give the separated piece at a point to a side, or back to where the planes leave it");
  addMany(command, "--measure", flags.measures, "x,y,z,x,y,z: keep the distance of two points with the plan");
  command.add_option("--plan", flags.plan, "The plan's name (default: the first)");
  command.add_option("--duplicate", flags.duplicate, "Go on with a copy of the plan under this name");
  command.add_option("--rename", flags.rename, "Give the plan this name");
  command.add_flag("--delete", flags.remove, "Delete the plan and show the first of the others");
  addMany(command, "--compare", flags.compare, "Another plan's name: one table with the plan; up to three");
  command.add_option("--height", flags.height, "The patient's height, cm, or none");
  command.add_option("--weight", flags.weight, "The patient's weight, kg, or none");
  command.add_option("--condition", flags.condition, "The liver: normal, long-chemotherapy, injured or none");
  command.add_option("--tumour-type", flags.tumourType, "colorectal-metastases, hepatocellular or none");
  addAcceptanceFlags(command, flags.acceptance);
  command.add_flag("--dry-run", flags.dryRun, "Show the numbers and store nothing");
  command.add_flag("--json", flags.json, "JSON on stdout");
  addTerritoryFlags(command, flags.territories);
}

namespace {
/// An edit beside --delete would fall on another plan than the one that is named.
void checkDeletesOnly(const PlanFlags& flags) {
  const std::array edits{std::pair{"--plane", !flags.planes.empty()},
                         std::pair{"--points", !flags.points.empty()},
                         std::pair{"--line", !flags.lines.empty()},
                         std::pair{"--slice", !flags.slices.empty()},
                         std::pair{"--propose-margin", !flags.proposeMargin.empty()},
                         std::pair{"--bend-plane", !flags.bendPlanes.empty()},
                         std::pair{"--flatten-plane", !flags.flattenPlanes.empty()},
                         std::pair{"--remove-resection", !flags.removeResection.empty()},
                         std::pair{"--margin", !flags.margin.empty()},
                         std::pair{"--island", !flags.islands.empty()},
                         std::pair{"--measure", !flags.measures.empty()},
                         std::pair{"--duplicate", !flags.duplicate.empty()},
                         std::pair{"--rename", !flags.rename.empty()}};
  for (const auto& [flag, given] : edits) {
    if (given) {
      throw UsageError(std::string("--delete and ") + flag +
                       " exclude each other: the plan that is named would be gone; give them in two calls");
    }
  }
}
}  // namespace

void checkFlags(const PlanFlags& flags) {
  if (flags.remove) {
    checkDeletesOnly(flags);
  }
  if (planesOf(flags, ImageGeometry()).empty() && !flags.bend.empty()) {
    throw UsageError("--bend needs a placed plane of the same call to bend; a proposed one would lose its margin");
  }
  (void)factsOf(flags, {});
  checkAcceptanceFlags(flags.acceptance);
  if (!flags.bend.empty()) {
    (void)bendOf(flags.bend);
  }
  for (const std::string& text : flags.bendPlanes) {
    (void)planeBendOf(text);
  }
  for (const std::string& text : flags.flattenPlanes) {
    (void)planeNumberOf("--flatten-plane", text);
  }
  for (const std::string& text : flags.islands) {
    (void)islandOf(text);
  }
  for (const std::string& text : flags.measures) {
    (void)measureOf(text);
  }
  if (!flags.margin.empty()) {
    (void)numberOf("--margin", flags.margin);
  }
}

std::vector<HalfSpace> planesOf(const PlanFlags& flags, const ImageGeometry& geometry) {
  std::vector<HalfSpace> planes;
  for (const std::string& text : flags.planes) {
    planes.push_back(typedPlane(text));
  }
  for (const std::string& text : flags.points) {
    const auto n = numbersOf("--points", text, 9, "nine numbers, three points x,y,z");
    planes.push_back(placed("--points", text, [&] { return planeThroughPoints(pointAt(n, 0), pointAt(n, 3), pointAt(n, 6)); }));
  }
  for (const std::string& text : flags.lines) {
    const auto n = numbersOf("--line", text, 9, "nine numbers, two points x,y,z and a direction dx,dy,dz");
    planes.push_back(placed("--line", text, [&] { return planeOfLine(pointAt(n, 0), pointAt(n, 3), pointAt(n, 6)); }));
  }
  for (const std::string& text : flags.slices) {
    planes.push_back(slicePlane(text, geometry));
  }
  if (flags.flip && planes.empty()) {
    throw UsageError("--flip needs a plane of the same call to turn around");
  }
  for (HalfSpace& plane : planes) {
    plane = flags.flip ? flipped(plane) : plane;
  }
  return planes;
}

namespace {
TypedBend bendOf(const std::string& flag, const std::string& text) {
  constexpr std::size_t kHeights = 16;
  const bool sized = partsOf(text).size() == kHeights + 1;
  const auto n = numbersOf(flag, text, sized ? kHeights + 1 : kHeights, "sixteen heights h0,...,h15 and, if wanted, a half size");
  TypedBend bend;
  std::copy_n(n.begin(), kHeights, bend.heightsMm.begin());
  if (sized) {
    bend.halfSizeMm = n.back();
  }
  return bend;
}
}  // namespace

TypedBend bendOf(const std::string& text) { return bendOf("--bend", text); }

TypedPlaneBend planeBendOf(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw UsageError("--bend-plane takes a plane's number and sixteen heights h0,...,h15, not \"" + text + "\"");
  }
  return {planeNumberOf("--bend-plane", text.substr(0, comma)), bendOf("--bend-plane", text.substr(comma + 1))};
}

std::size_t planeNumberOf(const std::string& flag, const std::string& text) {
  const auto number = parseNumber(text);
  constexpr double kMost = 1000;
  if (!number || !(*number >= 1 && *number <= kMost) || *number != std::floor(*number)) {
    throw UsageError(flag + " takes the number of a plane, counted from 1, not \"" + text + "\"");
  }
  return static_cast<std::size_t>(*number) - 1;
}

IslandAssignment islandOf(const std::string& text) {
  const std::size_t comma = text.rfind(',');
  const std::string side = comma == std::string::npos ? std::string() : text.substr(comma + 1);
  if (side != "resected" && side != "remnant" && side != "back") {
    throw UsageError("--island takes a point x,y,z and resected, remnant or back, not \"" + text + "\"");
  }
  const auto n = numbersOf("--island", text.substr(0, comma), 3, "a point x,y,z and resected, remnant or back");
  return {pointAt(n, 0), side == "resected" ? PlanSide::Resected : PlanSide::Remnant};
}

Measure measureOf(const std::string& text) {
  const auto n = numbersOf("--measure", text, 6, "six numbers, two points x,y,z");
  return {"", pointAt(n, 0), pointAt(n, 3)};
}

double numberOf(const std::string& flag, const std::string& text) {
  const auto number = parseNumber(text);
  if (!number) {
    throw UsageError(flag + " takes a number, not \"" + text + "\"");
  }
  return *number;
}

PatientFacts factsOf(const PlanFlags& flags, const PatientFacts& before) {
  PatientFacts facts = before;
  facts.heightCm = factOf("--height", flags.height, before.heightCm);
  facts.weightKg = factOf("--weight", flags.weight, before.weightKg);
  if (!flags.condition.empty()) {
    facts.condition = conditionFromId(flags.condition);
    if (!facts.condition && flags.condition != "none") {
      throw UsageError("--condition takes normal, long-chemotherapy, injured or none, not \"" + flags.condition + "\"");
    }
  }
  if (!flags.tumourType.empty()) {
    facts.tumourType = tumourTypeFromId(flags.tumourType);
    if (!facts.tumourType && flags.tumourType != "none") {
      throw UsageError("--tumour-type takes colorectal-metastases, hepatocellular or none, not \"" + flags.tumourType + "\"");
    }
  }
  return facts;
}

}  // namespace glisson::cli
