// The generated cases of marching cubes.
#include "reconstruction/poisson/marching_cases.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "reconstruction/mesh/self_intersection.h"

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

TEST(MarchingCases, NoCaseCrossesItselfWhereverItsVerticesLie) {
  const MarchingCases cases = makeMarchingCases();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(1e-3, 1 - 1e-3);
  std::uniform_real_distribution<double> nearEnd(1e-3, 2e-2);
  for (std::size_t inside = 1; inside < 255; ++inside) {
    for (int placement = 0; placement < 200; ++placement) {
      SurfaceMesh mesh;
      for (std::size_t edge = 0; edge < 12; ++edge) {
        const double t = std::array{anywhere(random), nearEnd(random), 1 - nearEnd(random)}[random() % 3];
        const int from = kEdgeFrom[edge];
        Vec3 p(from & 1, (from >> 1) & 1, from >> 2);
        p[static_cast<Eigen::Index>(edge / 4)] += t;
        mesh.vertices.push_back(p);
      }
      for (const auto& t : cases[inside]) {
        mesh.triangles.push_back({t[0], t[1], t[2]});
      }
      ASSERT_TRUE(selfIntersections(mesh).empty()) << "case " << inside << ", placement " << placement;
    }
  }
}

}  // namespace
}  // namespace glisson::poisson
