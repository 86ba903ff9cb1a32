#include "planning/volumetry/margin_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "planning/volumetry/box_corners.h"
#include "planning/volumetry/tumour_margin.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
/// Rounding must not take the margin below what is asked for.
constexpr double kSlackMm = 1e-6;

struct Candidate {
  Vec3 normal = Vec3::UnitZ();  ///< image frame
  std::int64_t units = 0;       ///< of F, resected
  bool valid = false;           ///< takes some of the liver and leaves some of F
  [[nodiscard]] bool betterThan(const Candidate& other) const {
    return valid != other.valid ? valid : valid && units < other.units;
  }
};

/// Everything one tumour's search reads; const once built.
struct Problem {
  Vec3 spacing;
  double margin = 0;
  VoxelRows liver;
  VoxelRows lesions;  ///< T inside L
  VoxelRows tumour;
  std::vector<Vec3> corners;  ///< of the tumour's hull

  /// The nearest plane of this direction that is clear of the tumour by `clearance` everywhere.
  [[nodiscard]] ImagePlane planeAt(const Vec3& normal, double clearance) const {
    double lowest = normal.dot(corners.front());
    for (const Vec3& corner : corners) {
      lowest = std::min(lowest, normal.dot(corner));
    }
    return {normal, clearance - lowest};
  }
  [[nodiscard]] double clearanceOf(const Vec3& normal) const { return margin + resolutionMm(normal, spacing) + kSlackMm; }

  [[nodiscard]] Candidate valued(const ImagePlane& plane) const {
    const std::vector<ImageResection> plan{{{plane}}};
    const std::int64_t taken = resectedUnits(liver, spacing, plan);
    const std::int64_t diseased = resectedUnits(lesions, spacing, plan);
    const auto functional = static_cast<std::int64_t>(liver.voxels - lesions.voxels) << 32;
    Candidate candidate{plane.normal, taken - diseased, false};
    candidate.valid = taken > 0 && candidate.units < functional;
    return candidate;
  }
  [[nodiscard]] Candidate valued(const Vec3& normal) const { return valued(planeAt(normal, clearanceOf(normal))); }

  /// The margin as it is assessed: to the plane's part inside L.
  [[nodiscard]] Margin marginTo(const ImagePlane& plane) const {
    const std::vector<ImageResection> plan{{{plane}}};
    return marginOf(TumourBoxes(tumour, spacing), spacing, CutDistance(cutSurface(liver, spacing, plan)));
  }
};

/// An even set of directions: a spiral with the golden angle.
std::vector<Vec3> spiral(std::size_t count) {
  std::vector<Vec3> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t n = 0; n < count; ++n) {
    const double z = 1 - 2 * (static_cast<double>(n) + 0.5) / static_cast<double>(count);
    const double radius = std::sqrt(1 - z * z);
    const double angle = golden * static_cast<double>(n);
    directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  // The axes themselves, which the spiral misses: many a best plane is parallel to a face of the voxels.
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    directions.emplace_back(Vec3::Unit(axis));
    directions.emplace_back(-Vec3::Unit(axis));
  }
  return directions;
}

std::vector<Candidate> valuedAll(const Problem& problem, const std::vector<Vec3>& directions, const ExecutionContext& context) {
  std::vector<Candidate> candidates(directions.size());
  parallelFor(directions.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      context.throwIfCancelled();
      candidates[n] = problem.valued(directions[n]);
    }
  });
  return candidates;
}

/// The best candidates that are at least `apart` rad from each other, best first.
std::vector<Candidate> distinctBest(std::vector<Candidate> candidates, std::size_t atMost, double apart) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.betterThan(b); });
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : candidates) {
    const bool near = std::any_of(chosen.begin(), chosen.end(),
                                  [&](const Candidate& known) { return known.normal.dot(candidate.normal) > std::cos(apart); });
    if (candidate.valid && !near && chosen.size() < atMost) {
      chosen.push_back(candidate);
    }
  }
  return chosen;
}

/// Follows the falling volume: eight neighbours at a step that is halved where none is better.
Candidate followed(const Problem& problem, Candidate best, double step, const ExecutionContext& context) {
  constexpr double kLeastStep = 1e-4;
  while (step > kLeastStep) {
    const Vec3 u = best.normal.unitOrthogonal();
    const Vec3 v = best.normal.cross(u);
    Candidate next = best;
    for (int n = 0; n < 8; ++n) {
      context.throwIfCancelled();
      const double angle = std::numbers::pi / 4 * n;
      const Vec3 turned = (best.normal + std::tan(step) * (std::cos(angle) * u + std::sin(angle) * v)).normalized();
      const Candidate candidate = problem.valued(turned);
      if (candidate.betterThan(next)) {
        next = candidate;
      }
    }
    if (next.betterThan(best)) {
      best = next;
    } else {
      step *= 0.5;
    }
  }
  return best;
}

/// The candidate's plane where the margin is assessed: away until it is kept, closer as long as it is.
std::optional<ImagePlane> settled(const Problem& problem, const Vec3& normal, const ExecutionContext& context) {
  const auto keeps = [&](double clearance) {
    context.throwIfCancelled();
    const Margin margin = problem.marginTo(problem.planeAt(normal, clearance));
    return std::isfinite(margin.mm) && margin.atLeast >= problem.margin + 0.5 * kSlackMm;
  };
  double good = problem.clearanceOf(normal);
  if (!keeps(good)) {
    // No way is coarser than half a voxel's diagonal.
    good = problem.margin + 0.5 * problem.spacing.norm() + kSlackMm;
    if (!keeps(good)) {
      return std::nullopt;
    }
  }
  constexpr double kFineMm = 0.01;
  double bad = 0;
  // Where the nearest part of the plane lies in L the margin is used up, and the first try already fails.
  if (keeps(good - kFineMm)) {
    good -= kFineMm;
    while (good - bad > kFineMm) {
      const double middle = 0.5 * (good + bad);
      (keeps(middle) ? good : bad) = middle;
    }
  }
  return problem.planeAt(normal, good);
}

struct Found {
  ImagePlane plane;
  Candidate value;
};

std::optional<Found> search(const Problem& problem, const ExecutionContext& context) {
  constexpr std::size_t kDirections = 600;  // some 8 degrees apart
  constexpr double kStep = 0.07;
  context.report(0.0, "margin plane");
  std::vector<Candidate> starts = distinctBest(valuedAll(problem, spiral(kDirections), context), 8, 3 * kStep);
  context.report(0.5, "margin plane");
  std::vector<Candidate> ends(starts.size());
  parallelFor(starts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      ends[n] = followed(problem, starts[n], kStep, context);
    }
  });
  context.report(0.8, "margin plane");
  std::optional<Found> best;
  for (const Candidate& end : distinctBest(ends, 4, 0.02)) {
    const std::optional<ImagePlane> plane = settled(problem, end.normal, context);
    if (!plane) {
      continue;
    }
    const Candidate value = problem.valued(*plane);
    if (value.valid && (!best || value.betterThan(best->value))) {
      best = Found{*plane, value};
    }
  }
  return best;
}

const Structure& tumourOf(const Case& source, const std::string& tumour) {
  const Structure* named = nullptr;
  std::size_t count = 0;
  std::string ids;
  for (const Structure& structure : source.model->structures) {
    if (!isLesion(structure.kind)) {
      continue;
    }
    if (structure.id == tumour) {
      return structure;
    }
    ids += (ids.empty() ? "" : ", ") + structure.id;
    if (structure.name == tumour) {
      named = &structure;
      ++count;
    }
  }
  if (count != 1) {
    throw PlanningError("The case has no tumour \"" + tumour + "\" that is named once; it has: " + (ids.empty() ? "none" : ids) +
                        ".");
  }
  return *named;
}

Problem problemOf(const Case& source, const Structure& tumour, double safetyMarginMm) {
  const auto& masks = source.segmentation->structures;
  const auto index = static_cast<std::size_t>(tumour.sourceIndex);
  if (tumour.sourceIndex < 0 || index >= masks.size() || !masks[index].mask || masks[index].mask->empty()) {
    throw PlanningError(tumour.name + " has no mask in this case; read the segmentation again.");
  }
  Problem problem;
  problem.spacing = source.liver->geometry.spacing;
  problem.margin = safetyMarginMm;
  problem.liver = rowsOf(source.liver->liver);
  problem.lesions = rowsOf(source.liver->tumour, &source.liver->liver);
  problem.tumour = rowsOf(*masks[index].mask);
  problem.corners = hullCorners(problem.tumour, problem.spacing);
  return problem;
}

/// The plane in the world, its origin in the middle of the cut.
HalfSpace toWorld(const Problem& problem, const ImagePlane& plane, const ImageGeometry& geometry) {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (const CutPiece& piece : cutSurface(problem.liver, problem.spacing, {{{plane}}})) {
    const Vec3 sum = std::accumulate(piece.polygon.begin(), piece.polygon.end(), Vec3(0, 0, 0));
    const double part = areaOf(piece.polygon);
    area += part;
    moment += part / static_cast<double>(piece.polygon.size()) * sum;
  }
  const Vec3 middle = moment / area;
  const Vec3 onPlane = middle - plane.distance(middle) * plane.normal;
  return {geometry.origin + geometry.direction * onPlane, (geometry.direction * plane.normal).normalized()};
}
}  // namespace

MarginProposal proposeMarginPlane(const Case& source, const std::string& tumour, double safetyMarginMm,
                                  const ExecutionContext& context) {
  if (!(std::isfinite(safetyMarginMm) && safetyMarginMm >= 0)) {
    throw PlanningError("The safety margin must be a number of millimetres, 0 or more.");
  }
  const Structure& structure = tumourOf(source, tumour);
  const Problem problem = problemOf(source, structure, safetyMarginMm);
  MarginProposal proposal{structure.id, structure.name, safetyMarginMm, {}, 0, 0, 0, {}, {}, {}};
  proposal.notice = "The proposed plane is geometry only: it ignores inflow, outflow and access.";
  const std::optional<Found> found = search(problem, context);
  if (!found) {
    proposal.reason = "No plane keeps " + formatExact(safetyMarginMm) + " mm around " + structure.name +
                      ": each one that does takes the whole functional liver or nothing of it.";
    return proposal;
  }
  const ImageGeometry& geometry = source.liver->geometry;
  proposal.plane = toWorld(problem, found->plane, geometry);
  const PlanAssessor assessor(source);
  const ResectionPlan plan{"", {{"", {*proposal.plane}}}, safetyMarginMm};
  const PlanAssessment assessment = assessor.assess(plan);
  proposal.resectedFunctionalMl = assessment.functionalMl - assessment.functionalRemnantMl;
  for (const TumourAssessment& assessed : assessment.tumours) {
    if (assessed.id == structure.id) {
      if (assessed.state != TumourState::Removed || !assessed.marginAtLeastMm || *assessed.marginAtLeastMm < safetyMarginMm) {
        throw CheckFailed("The proposed plane around " + structure.name + " does not keep its margin; place the plane by hand.");
      }
      proposal.marginMm = *assessed.marginMm;
      proposal.marginAtLeastMm = *assessed.marginAtLeastMm;
    }
  }
  std::copy_if(assessment.vesselsCrossed.begin(), assessment.vesselsCrossed.end(), std::back_inserter(proposal.vessels),
               [](const VesselCrossing& crossing) { return crossing.diameterMm >= kListedVesselMm; });
  context.report(1.0, "margin plane");
  return proposal;
}

}  // namespace glisson
