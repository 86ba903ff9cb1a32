#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <random>
#include <stdexcept>

#include "reconstruction/errors.h"
#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/parallel.h"
#include "tests/reconstruction/mcsd/plain_chain.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

const Index3 kSweepSize{40, 30, 26};
const std::vector<int> kSmoothings{0, 22, 45, 67, 90};
const std::vector<double> kDecimations{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

/// The sweep of method.md 3.
std::vector<McsdParameters> fifty(SmoothingFilter filter, McsdOrder order) {
  std::vector<McsdParameters> sets;
  for (const int smoothing : kSmoothings) {
    for (const double decimation : kDecimations) {
      sets.push_back({smoothing, filter, decimation, order, false});
    }
  }
  return sets;
}

/// Every set's result; fails where the sweep does not visit each set once.
std::vector<McsdResult> sweep(const Mask& mask, const ImageGeometry& geometry, const std::vector<McsdParameters>& sets) {
  std::vector<McsdResult> results(sets.size());
  std::vector<std::atomic<int>> visits(sets.size());
  sweepMcsd(mask, geometry, sets, [&](std::size_t set, McsdResult result, const ExecutionContext& /*share*/) {
    results[set] = std::move(result);
    ++visits[set];
  });
  for (const auto& count : visits) {
    EXPECT_EQ(count, 1);
  }
  return results;
}

Mask noise(std::mt19937& random, const Index3& size, unsigned percent) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (auto& v : values) {
    v = random() % 100 < percent ? 1 : 0;
  }
  values[0] = 1;
  return Mask::fromGrid(size, values);
}

/// The whole chain where every edge has two triangles; else it without the turning of triangles (mcsd.h).
void expectPlainChain(const SurfaceMesh& mesh, const Mask& mask, const ImageGeometry& geometry, const McsdParameters& p) {
  const bool sound = !p.splitNormals && mesh.defects().nonManifoldEdges == 0;  // a split edge tells no more whether it was sound
  test::expectSameTriangles(mesh, test::plainChain(mask, geometry, p, sound));
}

TEST(McsdSweep, OfFiftyModelsIsThePlainVtkChainTriangleForTriangleByBothFiltersAndOrders) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  std::vector<McsdParameters> sets;
  for (const auto filter : {SmoothingFilter::Sinc, SmoothingFilter::Laplacian}) {
    for (const auto order : {McsdOrder::DecimateFirst, McsdOrder::SmoothFirst}) {
      for (McsdParameters& p : fifty(filter, order)) {
        sets.push_back(p);
      }
    }
  }
  for (const bool leftHanded : {false, true}) {
    const ImageGeometry geometry = test::obliqueGeometry(kSweepSize, leftHanded);
    const auto results = sweep(mask, geometry, sets);
    for (std::size_t n = 0; n < sets.size(); ++n) {
      SCOPED_TRACE(n);
      expectPlainChain(results[n].mesh, mask, geometry, sets[n]);
    }
  }
}

TEST(McsdSweep, IsThePlainVtkChainWhereDecimationBreaksTheMeshToo) {
  std::mt19937 random(45);
  std::size_t broken = 0;
  for (int trial = 0; trial < test::trials(40); ++trial) {
    const Index3 size{9, 8, 10};
    const Mask mask = noise(random, size, 30);
    const ImageGeometry geometry = test::obliqueGeometry(size, trial % 2 == 1);
    std::vector<McsdParameters> sets;
    for (const int smoothing : {7, 22, 45}) {
      sets.push_back({smoothing, SmoothingFilter::Laplacian, 0.9, McsdOrder::DecimateFirst, smoothing == 22});
      sets.push_back({smoothing, SmoothingFilter::Sinc, 0.9, McsdOrder::DecimateFirst, false});
    }
    const auto results = sweep(mask, geometry, sets);
    for (std::size_t n = 0; n < sets.size(); ++n) {
      SCOPED_TRACE(n);
      expectPlainChain(results[n].mesh, mask, geometry, sets[n]);
    }
    broken += results[0].mesh.defects().nonManifoldEdges > 0 ? 1 : 0;
  }
  EXPECT_GT(broken, 0U);
}

TEST(McsdSweep, GivesTheSameBytesForAnyNumberOfThreads) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  const ImageGeometry geometry = test::obliqueGeometry(kSweepSize, false);
  const auto sets = fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst);
  std::vector<McsdResult> first;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    auto results = sweep(mask, geometry, sets);
    if (first.empty()) {
      first = std::move(results);
      continue;
    }
    for (std::size_t n = 0; n < sets.size(); ++n) {
      EXPECT_EQ(results[n].mesh.vertices, first[n].mesh.vertices) << n;
      EXPECT_EQ(results[n].mesh.triangles, first[n].mesh.triangles) << n;
    }
  }
}

TEST(McsdSweep, RunsWhatSetsHaveInCommonOnce) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  const ImageGeometry geometry = test::obliqueGeometry(kSweepSize, false);
  // Two runs of a filter never take the same time to the nanosecond: equal times are one run.
  const auto decimated = sweep(mask, geometry, fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst));
  const auto smoothed = sweep(mask, geometry, fifty(SmoothingFilter::Sinc, McsdOrder::SmoothFirst));
  for (std::size_t s = 0; s < kSmoothings.size(); ++s) {
    for (std::size_t e = 0; e < kDecimations.size(); ++e) {
      const std::size_t n = s * kDecimations.size() + e;
      EXPECT_EQ(decimated[n].extractSeconds, decimated[0].extractSeconds);
      EXPECT_EQ(decimated[n].decimateSeconds, decimated[e].decimateSeconds);
      EXPECT_EQ(smoothed[n].extractSeconds, smoothed[0].extractSeconds);
      EXPECT_EQ(smoothed[n].smoothSeconds, smoothed[s * kDecimations.size()].smoothSeconds);
      if (s > 0) {
        EXPECT_GT(decimated[n].smoothSeconds, decimated[n - kDecimations.size()].smoothSeconds);
      }
    }
  }
}

TEST(McsdSweep, HoldsOneResultAThreadAlsoWhileAVisitorUsesThreads) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  const ImageGeometry geometry = test::obliqueGeometry(kSweepSize, false);
  const auto sets = fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst);
  static thread_local int held = 0;
  const ThreadLimit limit(2);
  sweepMcsd(mask, geometry, sets, [&](std::size_t /*set*/, const McsdResult& result, const ExecutionContext& /*share*/) {
    ++held;
    std::atomic<std::size_t> sum{0};
    parallelFor(result.mesh.triangles.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        sum += result.mesh.triangles[n][0];
      }
    });
    EXPECT_EQ(held, 1);
    --held;
  });
}

TEST(McsdSweep, ProgressNeverFallsAndEndsAtOne) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  double last = 0.0;
  const ExecutionContext context([&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  sweepMcsd(
      mask, test::obliqueGeometry(kSweepSize, true), fifty(SmoothingFilter::Sinc, McsdOrder::SmoothFirst),
      [](std::size_t, const McsdResult&, const ExecutionContext& share) { share.report(1.0, "visitor"); }, context);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(McsdSweep, ACancelInAnyPhaseEndsIt) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  for (const std::string_view phaseToStop : {"marching cubes", "decimation", "smoothing", "visitor"}) {
    std::unique_ptr<ExecutionContext> context;
    std::atomic<std::size_t> taken{0};
    context = std::make_unique<ExecutionContext>([&](double, std::string_view phase) {
      if (phase == phaseToStop) {
        context->cancel();
      }
    });
    const auto visit = [&](std::size_t, const McsdResult&, const ExecutionContext& share) {
      ++taken;
      share.report(1.0, "visitor");
    };
    const auto sets = fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst);
    EXPECT_THROW(sweepMcsd(mask, test::obliqueGeometry(kSweepSize, false), sets, visit, *context), Cancelled) << phaseToStop;
    EXPECT_LT(taken, sets.size()) << phaseToStop;
  }
}

TEST(McsdSweep, AnExceptionOfAVisitorEndsIt) {
  const auto sets = fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst);
  std::atomic<std::size_t> taken{0};
  const auto visit = [&](std::size_t, const McsdResult&, const ExecutionContext&) {
    ++taken;
    throw std::length_error("no room");
  };
  EXPECT_THROW(sweepMcsd(test::asymmetricBody(kSweepSize), test::obliqueGeometry(kSweepSize, false), sets, visit),
               std::length_error);
  EXPECT_LT(taken, sets.size());
}

TEST(McsdSweep, RefusesASenselessSetAndAnEmptyMaskBeforeAnyWorkAndNothingIsNoWork) {
  const Mask mask = test::asymmetricBody(kSweepSize);
  const ImageGeometry geometry = test::obliqueGeometry(kSweepSize, false);
  const auto never = [](std::size_t, const McsdResult&, const ExecutionContext&) { FAIL(); };
  auto sets = fifty(SmoothingFilter::Laplacian, McsdOrder::DecimateFirst);
  EXPECT_THROW(sweepMcsd(Mask(), geometry, sets, never), ReconstructionError);
  EXPECT_NO_THROW(sweepMcsd(mask, geometry, {}, never));
  sets.back().decimation = 1.0;
  EXPECT_THROW(sweepMcsd(mask, geometry, sets, never), UsageError);
}

}  // namespace
}  // namespace glisson
