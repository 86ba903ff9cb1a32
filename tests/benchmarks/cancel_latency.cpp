// Measures how long a cancel takes to end a reconstruction: the time from cancel() to the return of reconstruct(), at moments
// spread evenly at random over the whole of its work.
//   cancel_latency [SEGMENTATION [MOMENTS]]     without a path, or with "-": the sample patient; 30 moments
// Prints median and worst for Poisson surface reconstruction at depth 5..9, at 9 with `paper` points, at 10, screened and
// simplified (at most 100 ms), and for marching cubes (at most 2 s); exit code 4 where a limit is passed.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/io/read.h"
#include "reconstruction/reconstruct.h"
#include "reconstruction/sample/sample_patient.h"

namespace glisson {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Seconds from the cancel to the end; below 0 where the work was done before.
double latency(const std::function<void(const ExecutionContext&)>& work, double afterSeconds) {
  const ExecutionContext context;
  Clock::time_point cancelledAt;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::duration<double>(afterSeconds));
    cancelledAt = Clock::now();
    context.cancel();
  });
  bool cancelled = false;
  try {
    work(context);
  } catch (const Cancelled&) {
    cancelled = true;
  }
  const Clock::time_point end = Clock::now();
  canceller.join();
  return cancelled ? std::chrono::duration<double>(end - cancelledAt).count() : -1.0;
}

bool measure(const char* name, double limitSeconds, int moments, const std::function<void(const ExecutionContext&)>& work) {
  const Clock::time_point start = Clock::now();
  work({});
  const double whole = secondsSince(start);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<double> found;
  double worstAt = 0;
  for (int n = 0; n < moments; ++n) {
    const double at = whole * share(random);
    const double seconds = latency(work, at);
    if (seconds >= 0) {
      worstAt = found.empty() || seconds > *std::ranges::max_element(found) ? at : worstAt;
      found.push_back(seconds);
    }
  }
  if (found.empty()) {
    std::printf("%-10s every run ended before its cancel\n", name);
    return false;
  }
  std::ranges::sort(found);
  std::printf("%-10s whole %7.3f s, %3zu cancels: median %7.1f ms, worst %7.1f ms (at %3.0f %% of the work)\n", name, whole,
              found.size(), 1e3 * found[found.size() / 2], 1e3 * found.back(), 100 * worstAt / whole);
  std::fflush(stdout);
  return found.back() <= limitSeconds;
}

bool measureAll(const Segmentation& segmentation, int moments) {
  const Mask liver = liverVoxels(segmentation).liver;
  constexpr double kPsrLimit = 0.1;
  constexpr double kMcsdLimit = 2.0;
  ReconstructionParameters parameters;
  const auto work = [&](const ExecutionContext& context) {
    (void)reconstruct(liver, segmentation.geometry, StructureKind::Liver, parameters, context);
  };
  bool kept = true;
  for (const int depth : {5, 6, 7, 8, 9}) {
    parameters.method = Method::Psr;
    parameters.psr.depth = depth;
    kept &= measure(("PSR d=" + std::to_string(depth)).c_str(), kPsrLimit, moments, work);
  }
  parameters.psr.sampling = Sampling::Paper;
  kept &= measure("paper d=9", kPsrLimit, moments, work);
  parameters.psr.sampling = Sampling::Unbiased;
  parameters.psr.depth = 10;
  parameters.psr.scale = 1.6;  // a cube in which a liver of half-millimetre pixels carries depth 10
  kept &= measure("d=10 wide", kPsrLimit, moments, work);
  parameters.psr = {.depth = 8, .pointWeight = 8};
  kept &= measure("screened", kPsrLimit, moments, work);
  parameters.psr = {.depth = 9};
  parameters.simplify = SimplifyTarget{.triangles = 10000};
  kept &= measure("simplified", kPsrLimit, moments, work);
  parameters.simplify.reset();
  parameters.method = Method::Mcsd;
  kept &= measure("MCSD", kMcsdLimit, moments, work);
  return kept;
}

}  // namespace
}  // namespace glisson

int main(int argc, char** argv) {
  try {
    const bool sample = argc < 2 || std::string_view(argv[1]) == "-";
    const glisson::Segmentation segmentation =
        sample ? glisson::makeSamplePatient(false).segmentation : glisson::readSegmentation(argv[1]);
    const int moments = argc > 2 ? std::atoi(argv[2]) : 30;
    return glisson::measureAll(segmentation, moments) ? 0 : 4;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cancel_latency: %s\n", error.what());
    return 3;
  }
}
