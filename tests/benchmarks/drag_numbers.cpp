// Measures how long the numbers of a plan take while its plane moves: a drag across the whole liver and back with a wobble, each
// step as one mouse move.
//   drag_numbers CASE.glisson [STEPS]     2,000 steps; make the case with glisson-cli model
// Prints median, 99th percentile and worst of PlanAssessor::assessMoving() (every mouse move: volumes, tumours, vessels), of
// volumes() alone (what is left of it where the rest does not fit into a frame) and of cutting the parenchyma's mesh by the plane;
// both also with the plane bent, its heights waving by up to 25 mm; all numbers also with the plane as one side of a wedge, and
// beside a second resection. Exit code 4 where assessMoving() of the flat plane
// passes 16 ms at the 99th percentile.

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "planning/storage/case_file.h"
#include "planning/volumetry/assessment.h"
#include "reconstruction/mesh/cut.h"

namespace glisson {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameMs = 16;

template <typename Work>
double milliseconds(const Work& work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Prints a row; returns the 99th percentile.
double tell(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const double p99 = times[(times.size() - 1) * 99 / 100];
  std::printf("| %s | %zu | %.2f | %.2f | %.2f |\n", what, times.size(), times[times.size() / 2], p99, times.back());
  return p99;
}

/// Of the liver's box, in voxels.
Vec3 middleOf(const Case& source, double along = 0.5) {
  const IndexBox& box = source.liver->liver.box();
  return Vec3(box.first[0], box.first[1], box.first[2]) +
         Vec3(box.size[0], box.size[1], box.size[2]).cwiseProduct(Vec3(along, 0.5, 0.5));
}

ResectionPlan planAt(const Case& source, double share) {
  const LiverVoxels& liver = *source.liver;
  const double turn = 2 * std::numbers::pi * share;
  const Vec3 at = middleOf(source, 0.5 + 0.48 * std::sin(turn));
  const Vec3 normal = Vec3(1, 0.5 * std::sin(7 * turn), 0.3 * std::cos(5 * turn)).normalized();
  ResectionPlan plan;
  plan.resections.push_back({.name = "Resection 1", .planes = {{liver.geometry.toWorld(at), normal}}});
  return plan;
}

/// The same plane, its control points waving.
ResectionPlan bentAt(const Case& source, double share) {
  ResectionPlan plan = planAt(source, share);
  ResectionPlane& plane = plan.resections[0].planes[0];
  plane.bend = flatBend(plane, 90);
  for (std::size_t n = 0; n < 16; ++n) {
    plane.bend->heightsMm[n] = 25 * std::sin(2 * std::numbers::pi * 3 * share + 1.7 * static_cast<double>(n));
  }
  return plan;
}

/// The same plane and one across it through the liver's middle: a wedge, or two resections.
ResectionPlan besideAnother(const Case& source, double share, bool wedge) {
  ResectionPlan plan = planAt(source, share);
  const ResectionPlane& moved = plan.resections[0].planes[0];
  const Vec3 across = moved.normal.cross(Vec3::UnitX()).normalized();
  const ResectionPlane other(source.liver->geometry.toWorld(middleOf(source)), across);
  if (wedge) {
    plan.resections[0].planes.push_back(other);
  } else {
    plan.resections.push_back({.name = "Resection 2", .planes = {other}});
  }
  return plan;
}

int run(const std::string& path, int steps) {
  const Case source = CaseFile::open(path).load();
  const PlanAssessor assessor(source);
  const Structure* parenchyma = source.model->find("parenchyma");
  std::vector<double> volumes;
  std::vector<double> cuts;
  std::vector<double> whole;
  std::vector<double> bentVolumes;
  std::vector<double> bentWhole;
  std::vector<double> wedges;
  std::vector<double> pairs;
  for (int n = 0; n < steps; ++n) {
    const ResectionPlan plan = planAt(source, static_cast<double>(n) / steps);
    const ResectionPlan bent = bentAt(source, static_cast<double>(n) / steps);
    PlanAssessment now;
    PlanAssessment curved;
    volumes.push_back(milliseconds([&] { now = assessor.volumes(plan); }));
    bentVolumes.push_back(milliseconds([&] { curved = assessor.volumes(bent); }));
    if (now.resectedMl + now.remnantMl != now.totalMl || curved.resectedMl + curved.remnantMl != curved.totalMl) {
      std::fprintf(stderr, "resected and remnant do not add up at step %d\n", n);
      return 4;
    }
    if (n % 20 == 0) {
      if (parenchyma != nullptr && parenchyma->reconstruction) {
        cuts.push_back(milliseconds([&] { (void)cut(parenchyma->reconstruction->mesh, plan.resections[0].planes[0]); }));
      }
    }
    whole.push_back(milliseconds([&] { (void)assessor.assessMoving(plan); }));
    bentWhole.push_back(milliseconds([&] { (void)assessor.assessMoving(bent); }));
    for (const bool wedge : {true, false}) {
      const ResectionPlan both = besideAnother(source, static_cast<double>(n) / steps, wedge);
      (wedge ? wedges : pairs).push_back(milliseconds([&] { (void)assessor.assessMoving(both); }));
    }
  }
  std::printf("| numbers | steps | median ms | p99 ms | worst ms |\n|---|---|---|---|---|\n");
  const double p99 = tell("all numbers", whole);
  tell("all numbers of a bent plane", bentWhole);
  tell("all numbers of a wedge", wedges);
  tell("all numbers of two resections", pairs);
  tell("volumes alone", volumes);
  tell("volumes alone of a bent plane", bentVolumes);
  if (!cuts.empty()) {
    tell("capped halves of the parenchyma's mesh", cuts);
  }
  return p99 <= kFrameMs ? 0 : 4;
}

}  // namespace
}  // namespace glisson

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: drag_numbers CASE.glisson [STEPS]\n");
    return 2;
  }
  try {
    return glisson::run(argv[1], argc > 2 ? std::max(100, std::atoi(argv[2])) : 2000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "drag_numbers: %s\n", error.what());
    return 3;
  }
}
