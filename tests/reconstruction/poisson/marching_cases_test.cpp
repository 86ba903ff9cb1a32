// The generated cases of marching cubes.
#include "reconstruction/poisson/marching_cases.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace glisson::poisson {
namespace {

TEST(MarchingCases, UseExactlyTheEdgesWhoseEndsDiffer) {
  const MarchingCases cases = makeMarchingCases();
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::set<int> used;
    for (const auto& triangle : cases[inside]) {
      used.insert(triangle.begin(), triangle.end());
    }
    for (int edge = 0; edge < 12; ++edge) {
      const unsigned from = static_cast<unsigned>(kEdgeFrom[static_cast<std::size_t>(edge)]);
      const unsigned to = from | (1U << (edge / 4));
      EXPECT_EQ(((inside >> from) & 1U) != ((inside >> to) & 1U), used.contains(edge)) << inside << " " << edge;
    }
  }
}

TEST(MarchingCases, EveryInnerEdgeJoinsTwoTrianglesInOppositeDirections) {
  for (const auto& triangles : makeMarchingCases()) {
    std::map<std::pair<int, int>, int> directed;
    for (const auto& t : triangles) {
      for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_EQ((++directed[{t[n], t[(n + 1) % 3]}]), 1);
      }
    }
  }
}

TEST(MarchingCases, ACornerInsideIsCutOffWithItsNormalOutward) {
  const MarchingCases cases = makeMarchingCases();
  ASSERT_EQ(cases[1].size(), 1U);
  EXPECT_EQ(cases[1][0], (std::array<std::uint8_t, 3>{0, 4, 8}));  // x, y, z edge: its normal is (1, 1, 1)
}

}  // namespace
}  // namespace glisson::poisson
