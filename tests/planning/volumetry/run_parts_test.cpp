// The stretches that a plan cuts runs of voxels into, against each voxel counted by itself.

#include "planning/volumetry/run_parts.h"

#include <gtest/gtest.h>

#include <random>

#include "planning/volumetry/row_table.h"

namespace glisson {
namespace {

const Vec3 kRunSpacing(0.7, 0.9, 2.5);

VoxelRows someRows(std::mt19937& random) {
  VoxelRows rows;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 12; ++j) {
      for (int i = static_cast<int>(random() % 6); i < 40;) {
        const int n = 1 + static_cast<int>(random() % 20);
        rows.runs.push_back({i, j, k, n});
        rows.voxels += static_cast<std::size_t>(n);
        i += n + 1 + static_cast<int>(random() % 5);
      }
    }
  }
  return rows;
}

/// Askew, along an axis, or nearly so; through the rows. On voxels' faces and centres now and then.
ImagePlane somePlane(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vec3 direction(normal(random), normal(random), normal(random));
  if (random() % 3 == 0) {
    direction = Vec3::Unit(static_cast<Eigen::Index>(random() % 3)) * (random() % 2 == 0 ? 1 : -1);
    direction += (random() % 2 == 0 ? 1e-9 : 0.0) * Vec3(normal(random), normal(random), normal(random));
  }
  direction.normalize();
  const Vec3 through = 0.5 * kRunSpacing.cwiseProduct(Vec3(static_cast<double>(random() % 90), static_cast<double>(random() % 24),
                                                           static_cast<double>(random() % 8)));
  return {direction, -direction.dot(through)};
}

std::vector<ImageResection> somePlan(std::mt19937& random) {
  std::vector<ImageResection> plan(1 + random() % 2);
  for (ImageResection& resection : plan) {
    for (std::size_t n = random() % 3; n < 2; ++n) {
      resection.planes.push_back(somePlane(random));
    }
  }
  return plan;
}

TEST(RunParts, AreTheVoxelsOneByOne) {
  std::mt19937 random(11);
  std::size_t longDivided = 0;
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    const VoxelRows rows = someRows(random);
    const std::vector<ImageResection> plan = somePlan(random);
    const std::vector<RunPart> parts = partsOf(rows, kRunSpacing, plan);
    // What two resections have of a voxel is made of bodies, each rounded for itself.
    const std::int64_t rounding = plan.size() == 1 ? 0 : 1024;
    std::size_t part = 0;
    int done = 0;
    for (const RowRun& run : rows.runs) {
      for (int i = run.i; i < run.i + run.n;) {
        ASSERT_LT(part, parts.size());
        const RunPart& now = parts[part++];
        ASSERT_EQ(now.run.i, i);
        ASSERT_EQ(now.run.j, run.j);
        ASSERT_EQ(now.run.k, run.k);
        ASSERT_LE(i + now.run.n, run.i + run.n);
        std::int64_t units = 0;
        for (int voxel = i; voxel < i + now.run.n; ++voxel) {
          const std::int64_t one = resect({{{voxel, run.j, run.k, 1}}, 1}, kRunSpacing, plan).totalUnits();
          units += one;
          if (now.isDivided()) {
            EXPECT_TRUE(one > 0 && one < std::int64_t{1} << 32);
          } else {
            EXPECT_LE(std::abs(one - now.resected / now.run.n), rounding);
          }
        }
        EXPECT_LE(std::abs(units - now.resected), now.run.n * (1 + rounding)) << "a unit of rounding for each voxel";
        longDivided += now.isDivided() && now.run.n > 2 ? 1 : 0;
        i += now.run.n;
        ++done;
      }
    }
    ASSERT_EQ(part, parts.size());
    ASSERT_GT(done, 0);
  }
  EXPECT_GT(longDivided, 1000U) << "stretches that one plane cuts are counted in one go";
}

TEST(RowTable, FindsWhatIsInARowAndNothingElsewhere) {
  std::mt19937 random(12);
  VoxelRows rows = someRows(random);
  std::erase_if(rows.runs, [](const RowRun& run) { return run.j == 5 || run.k == 2; });
  const RowTable table(rows.runs.size(), [&](std::size_t n) { return rows.runs[n]; });
  std::size_t seen = 0;
  for (int k = -2; k < 7; ++k) {
    for (int j = -2; j < 15; ++j) {
      const RowTable::Range range = table.row(j, k);
      for (std::size_t n = range.begin; n < range.end; ++n) {
        EXPECT_EQ(rows.runs[n].j, j);
        EXPECT_EQ(rows.runs[n].k, k);
        EXPECT_EQ(n, seen++);
      }
    }
  }
  EXPECT_EQ(seen, rows.runs.size());
  std::size_t visited = 0;
  table.forEachRow([&](int, int, const RowTable::Range& range) { visited += range.end - range.begin; });
  EXPECT_EQ(visited, rows.runs.size());
  EXPECT_EQ(RowTable().row(0, 0).end, 0U);
}

}  // namespace
}  // namespace glisson
