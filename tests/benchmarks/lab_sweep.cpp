// The published experiment's 54 models of one structure (method.md 3 and 4): 50 MCSD models by sweepMcsd() and PSR at depths 5 to
// 8, with every measure taken. Says where the time goes.
//   lab_sweep SEGMENTATION STRUCTURE [--no-measures]
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/mesh/curvature.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {
namespace {

using Clock = std::chrono::steady_clock;

/// Seconds by what they were spent on, summed over threads.
class Spent {
 public:
  template <typename Work>
  auto on(const std::string& what, Work&& work) {
    const auto start = Clock::now();
    auto result = work();
    add(what, std::chrono::duration<double>(Clock::now() - start).count());
    return result;
  }
  void add(const std::string& what, double seconds) {
    const std::lock_guard lock(mutex_);
    seconds_[what] += seconds;
  }
  void print() const {
    for (const auto& [what, seconds] : seconds_) {
      std::printf("  %-16s %8.2f s\n", what.c_str(), seconds);
    }
  }

 private:
  std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

struct Numbers {
  std::size_t triangles = 0;
  double paperErrorMm = 0;
  double curvaturePerMm2 = 0;
  std::vector<std::string> defects = {};
};

class Lab {
 public:
  Lab(const Mask& mask, const ImageGeometry& geometry, bool measures) : mask_(mask), geometry_(geometry), measures_(measures) {}

  Numbers measured(const SurfaceMesh& mesh) {
    Numbers numbers{.triangles = mesh.triangles.size()};
    numbers.defects = spent_.on("defects", [&] { return mesh.defects(); }).names();
    if (measures_) {
      numbers.paperErrorMm = spent_.on("paper error", [&] { return paperError(mesh, mask_, geometry_).mean; });
      numbers.curvaturePerMm2 = spent_.on("curvature", [&] { return meanGaussianCurvature(mesh).trimmedPerMm2; });
    }
    return numbers;
  }

  void run() {
    const auto start = Clock::now();
    std::vector<McsdParameters> sets;
    for (const int smoothing : {0, 22, 45, 67, 90}) {
      for (int tenth = 0; tenth < 10; ++tenth) {
        sets.push_back({smoothing, SmoothingFilter::Laplacian, tenth / 10.0, McsdOrder::DecimateFirst, false});
      }
    }
    std::vector<Numbers> rows(sets.size());
    sweepMcsd(mask_, geometry_, sets, [&](std::size_t n, const McsdResult& made, const ExecutionContext& /*share*/) {
      if (sets[n].smoothing == 90) {  // the longest of each decimation holds the seconds of all before it
        spent_.add("decimation", made.decimateSeconds);
        spent_.add("smoothing", made.smoothSeconds);
      }
      if (n == 0) {
        spent_.add("marching cubes", made.extractSeconds);
      }
      rows[n] = measured(made.mesh);
    });
    std::printf("50 MCSD models: %.2f s\n", std::chrono::duration<double>(Clock::now() - start).count());
    for (std::size_t n = 0; n < sets.size(); ++n) {
      print("MCSD s=" + std::to_string(sets[n].smoothing) + " e=" + std::to_string(n % 10 * 10) + " %", rows[n]);
    }
    for (const int depth : {5, 6, 7, 8}) {
      const PoissonResult made =
          spent_.on("PSR", [&] { return reconstructPoisson(mask_, geometry_, {.depth = depth, .sampling = Sampling::Paper}); });
      print("PSR d=" + std::to_string(depth), measured(made.mesh));
    }
    std::printf("54 models: %.2f s of wall clock; by stage, summed over threads:\n",
                std::chrono::duration<double>(Clock::now() - start).count());
    spent_.print();
  }

 private:
  static void print(const std::string& name, const Numbers& numbers) {
    std::string defects;
    for (const std::string& one : numbers.defects) {
      defects += "  " + one;
    }
    std::printf("  %-16s %8zu triangles  %.3f mm  K %.5f%s\n", name.c_str(), numbers.triangles, numbers.paperErrorMm,
                numbers.curvaturePerMm2, defects.c_str());
  }

  const Mask& mask_;
  const ImageGeometry& geometry_;
  bool measures_;
  Spent spent_;
};

int run(const std::vector<std::string>& words) {
  if (words.size() < 2) {
    std::fputs("usage: lab_sweep SEGMENTATION STRUCTURE [--no-measures]\n", stderr);
    return 2;
  }
  const Segmentation segmentation = readSegmentation(words[0]);
  for (const LabelledMask& one : segmentation.structures) {
    if (one.name == words[1]) {
      Lab(*one.mask, segmentation.geometry, words.size() == 2).run();
      return 0;
    }
  }
  throw UsageError(words[0] + " has no structure " + words[1] + ".");
}

}  // namespace
}  // namespace glisson

int main(int count, char** words) {
  try {
    return glisson::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lab_sweep: %s\n", error.what());
    return 3;
  }
}
