// The tree's answers are those of looking at every point, ties on a grid included.
#include "reconstruction/methods/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

namespace glisson {
namespace {

std::vector<std::uint32_t> nearestByLooking(const std::vector<Vec3>& points, const Vec3& at, std::size_t count) {
  std::vector<std::uint32_t> places(points.size());
  std::iota(places.begin(), places.end(), 0U);
  std::sort(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair((points[a] - at).squaredNorm(), a) < std::pair((points[b] - at).squaredNorm(), b);
  });
  places.resize(std::min(count, places.size()));
  return places;
}

std::vector<Vec3> randomPoints(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-20, 20);
  std::vector<Vec3> points;
  for (int n = 0; n < count; ++n) {
    points.emplace_back(value(random), value(random), value(random));
  }
  return points;
}

std::vector<Vec3> gridPoints() {
  std::vector<Vec3> points;
  for (int n = 0; n < 12 * 12 * 12; ++n) {
    points.emplace_back(n % 12, n / 12 % 12, n / 144);
  }
  return points;
}

TEST(PointTree, FindsTheNearestPointsInTheirOrder) {
  for (const auto& points : {randomPoints(1500), gridPoints()}) {
    const PointTree tree(points);
    std::vector<std::uint32_t> found;
    for (int n = 0; n < 200; ++n) {
      const Vec3 at = n % 2 == 0 ? points[static_cast<std::size_t>(7 * n)] : randomPoints(200)[static_cast<std::size_t>(n)];
      for (const std::size_t count : {1U, 10U, 27U}) {
        tree.nearest(at, count, found);
        EXPECT_EQ(found, nearestByLooking(points, at, count));
      }
    }
  }
}

TEST(PointTree, FindsWhatIsNearerThanTheRadiusAndNothingElse) {
  const auto points = gridPoints();
  const PointTree tree(points);
  std::vector<std::uint32_t> found;
  for (const double radius : {0.5, 2.0, 3.7, 40.0}) {
    const Vec3 centre(5, 4.5, 6);
    tree.within(centre, radius, found);
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t n = 0; n < points.size(); ++n) {
      if ((points[n] - centre).norm() < radius) {
        wanted.push_back(n);
      }
    }
    EXPECT_EQ(found, wanted);
  }
}

TEST(PointTree, HasAllPointsWhereThereAreFewAndRefusesNone) {
  const std::vector<Vec3> three{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  std::vector<std::uint32_t> found;
  PointTree(three).nearest(Vec3(2, 0, 0), 10, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_THROW(PointTree(std::vector<Vec3>{}), std::invalid_argument);
}

}  // namespace
}  // namespace glisson
