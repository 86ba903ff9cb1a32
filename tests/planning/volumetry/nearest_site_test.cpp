#include "planning/volumetry/nearest_site.h"

#include <gtest/gtest.h>

#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {
namespace {

double distance(const Vec3& spacing, const Index3& a, const Index3& b) {
  return spacing.cwiseProduct(Vec3(a[0] - b[0], a[1] - b[1], a[2] - b[2])).norm();
}

std::vector<Index3> randomSites(const IndexBox& box, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index3> sites;
  for (int n = 0; n < count; ++n) {
    Index3 site{};
    for (std::size_t a = 0; a < 3; ++a) {
      site[a] = box.first[a] + static_cast<int>(random() % static_cast<unsigned>(box.size[a]));
    }
    sites.push_back(site);
  }
  return sites;
}

TEST(NearestSites, AreThoseOfASearchThroughAllOfThem) {
  const IndexBox box{{-3, 5, 100}, {23, 17, 11}};
  for (const Vec3& spacing : {Vec3(1, 1, 1), Vec3(0.57, 0.57, 1.6), Vec3(0.8, 2.5, 0.3)}) {
    for (const int count : {1, 2, 40, 500}) {
      const std::vector<Index3> sites = randomSites(box, count, static_cast<unsigned>(count));
      const std::vector<std::int32_t> nearest = nearestSites(box, spacing, sites);
      std::size_t at = 0;
      for (int k = 0; k < box.size[2]; ++k) {
        for (int j = 0; j < box.size[1]; ++j) {
          for (int i = 0; i < box.size[0]; ++i, ++at) {
            const Index3 voxel{box.first[0] + i, box.first[1] + j, box.first[2] + k};
            double best = 1e9;
            for (const Index3& site : sites) {
              best = std::min(best, distance(spacing, voxel, site));
            }
            ASSERT_GE(nearest[at], 0);
            ASSERT_NEAR(distance(spacing, voxel, sites[static_cast<std::size_t>(nearest[at])]), best, 1e-9);
          }
        }
      }
    }
  }
}

TEST(NearestSites, AreTheSameForAnyNumberOfThreads) {
  const IndexBox box{{0, 0, 0}, {40, 40, 40}};
  const std::vector<Index3> sites = randomSites(box, 300, 7);
  std::vector<std::vector<std::int32_t>> made;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    made.push_back(nearestSites(box, Vec3(1, 1, 2), sites));
  }
  EXPECT_EQ(made[0], made[1]);
  EXPECT_EQ(made[0], made[2]);
}

TEST(NearestSites, OfNoSitesIsNone) {
  const std::vector<std::int32_t> nearest = nearestSites({{0, 0, 0}, {3, 4, 5}}, Vec3(1, 1, 1), {});
  EXPECT_EQ(nearest, std::vector<std::int32_t>(60, kNoSite));
}

TEST(NearestSites, OutsideTheBoxAreRefusedAndACancelEndsTheWork) {
  const std::vector<Index3> outside{{3, 0, 0}};
  EXPECT_THROW(nearestSites({{0, 0, 0}, {3, 3, 3}}, Vec3(1, 1, 1), outside), std::invalid_argument);
  const ExecutionContext context;
  context.cancel();
  const std::vector<Index3> inside{{0, 0, 0}};
  EXPECT_THROW(nearestSites({{0, 0, 0}, {3, 3, 3}}, Vec3(1, 1, 1), inside, context), Cancelled);
}

}  // namespace
}  // namespace glisson
