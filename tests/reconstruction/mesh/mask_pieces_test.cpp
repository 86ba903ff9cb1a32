#include "reconstruction/mesh/mask_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/mesh/centreline.h"
#include "reconstruction/mesh/inside_rows.h"

namespace glisson {
namespace {

Mask maskOf(const Index3& size, const std::vector<Index3>& voxels) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0);
  for (const Index3& v : voxels) {
    values[static_cast<std::size_t>(v[0] + size[0] * (v[1] + size[1] * v[2]))] = 1;
  }
  return Mask::fromGrid(size, values);
}

Mask randomMask(std::mt19937& random, const Index3& size, unsigned percent) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0);
  for (auto& v : values) {
    v = random() % 100 < percent ? 1 : 0;
  }
  values.front() = 1;
  return Mask::fromGrid(size, values);
}

/// A box of `size` with the voxels of `holes` left out.
Mask boxWithout(const Index3& size, const std::vector<Index3>& holes) {
  std::vector<Index3> voxels;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        if (std::find(holes.begin(), holes.end(), Index3{i, j, k}) == holes.end()) {
          voxels.push_back({i, j, k});
        }
      }
    }
  }
  return maskOf(size, voxels);
}

SurfaceMesh marchingCubes(const Mask& mask, const ImageGeometry& geometry) {
  return reconstructMcsd(mask, geometry, {0, SmoothingFilter::Sinc, 0.0, McsdOrder::DecimateFirst, false}).mesh;
}

TEST(MaskPieces, VoxelsThatTouchInACornerAreOnePieceOf26AndTwoOf6) {
  const Mask mask = maskOf({9, 9, 9}, {{2, 3, 4}, {3, 4, 5}, {8, 8, 8}});
  EXPECT_EQ(piecesOf(mask, Neighbours::TwentySix).voxels, (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(piecesOf(mask, Neighbours::Six).voxels, (std::vector<std::size_t>{1, 1, 1}));
}

TEST(MaskPieces, ACavityIsABackgroundPieceThatCannotLeave) {
  EXPECT_EQ(cavitiesOf(boxWithout({5, 5, 5}, {{2, 2, 2}, {2, 2, 3}}), Neighbours::Six).voxels, (std::vector<std::size_t>{2}));
  EXPECT_EQ(cavitiesOf(boxWithout({5, 5, 5}, {{2, 2, 3}, {2, 2, 4}}), Neighbours::Six).count(), 0U);
  // A cavity that meets the outside in an edge only.
  const Mask leaking = boxWithout({5, 5, 5}, {{2, 3, 3}, {2, 4, 4}});
  EXPECT_EQ(cavitiesOf(leaking, Neighbours::Six).count(), 1U);
  EXPECT_EQ(cavitiesOf(leaking, Neighbours::TwentySix).count(), 0U);
}

TEST(MaskPieces, EulerNumbersOfABallARingAndAShell) {
  const auto all = [](const EulerNumbers& e) {
    return std::vector<long long>{e.facesEdgesCorners, e.facesEdges, e.faces, e.facesAsCubes};
  };
  EXPECT_EQ(all(eulerNumbers(boxWithout({5, 5, 5}, {}))), std::vector<long long>(4, 1));
  EXPECT_EQ(all(eulerNumbers(boxWithout({5, 5, 1}, {{2, 2, 0}}))), std::vector<long long>(4, 0));
  EXPECT_EQ(all(eulerNumbers(boxWithout({5, 5, 5}, {{2, 2, 2}}))), std::vector<long long>(4, 2));
  EXPECT_EQ(all(eulerNumbers(boxWithout({70, 3, 1}, {{20, 1, 0}, {64, 1, 0}}))), std::vector<long long>(4, -1));
}

TEST(MaskPieces, EulerNumbersDifferWhereVoxelsMeetInEdgesAndCorners) {
  const EulerNumbers edge = eulerNumbers(maskOf({3, 3, 3}, {{0, 0, 0}, {0, 1, 1}}));
  EXPECT_EQ(edge.facesEdgesCorners, 1);
  EXPECT_EQ(edge.facesEdges, 1);
  EXPECT_EQ(edge.faces, 2);
  EXPECT_EQ(edge.facesAsCubes, 2);
  const EulerNumbers corner = eulerNumbers(maskOf({3, 3, 3}, {{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(corner.facesEdgesCorners, 1);
  EXPECT_EQ(corner.facesEdges, 2);
  EXPECT_EQ(corner.faces, 2);
}

TEST(MaskPieces, TheMarchingCubesSurfaceOfAnyMaskHasItsEulerNumberAndItsPieces) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const Index3 size{3 + static_cast<int>(random() % 8), 3 + static_cast<int>(random() % 8), 3 + static_cast<int>(random() % 8)};
    const Mask mask = randomMask(random, size, 10 + static_cast<unsigned>(random() % 85));
    ImageGeometry geometry;
    geometry.size = size;
    const SurfaceMesh mesh = marchingCubes(mask, geometry);
    ASSERT_EQ(eulerCharacteristic(mesh), 2 * eulerNumbers(mask).facesAsCubes) << trial;
    std::uint32_t surfaces = 0;
    componentOfTriangles(mesh, surfaces);
    // 18-connected background: between the cavities of 6 and of 26.
    const std::size_t pieces = piecesOf(mask, Neighbours::Six).count();
    ASSERT_GE(surfaces, pieces + cavitiesOf(mask, Neighbours::TwentySix).count()) << trial;
    ASSERT_LE(surfaces, pieces + cavitiesOf(mask, Neighbours::Six).count()) << trial;
  }
}

TEST(InsideRows, ExactlyTheMasksVoxelsAreInsideItsMarchingCubesSurface) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 60; ++trial) {
    const Index3 size{4 + static_cast<int>(random() % 6), 4 + static_cast<int>(random() % 6), 4 + static_cast<int>(random() % 6)};
    const Mask mask = randomMask(random, size, 10 + static_cast<unsigned>(random() % 85));
    ImageGeometry geometry;
    geometry.size = size;
    geometry.spacing = Vec3(0.57, 0.71, 1.6);
    geometry.origin = Vec3(-110.25, 43.5, -712.75);
    geometry.direction = (Mat3() << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, trial % 2 == 0 ? 1 : -1).finished();
    const InsideRows rows(marchingCubes(mask, geometry), geometry);
    for (int k = -1; k <= size[2]; ++k) {
      for (int j = -1; j <= size[1]; ++j) {
        for (int i = -1; i <= size[0]; ++i) {
          ASSERT_EQ(rows.isInside(i, j, k), mask.at(i, j, k)) << trial << ": " << i << " " << j << " " << k;
        }
      }
    }
  }
}

TEST(Centreline, OfAStraightTubeIsItsAxis) {
  std::vector<Index3> voxels;
  for (int i = 0; i < 60; ++i) {
    for (int j = -4; j <= 4; ++j) {
      for (int k = -4; k <= 4; ++k) {
        if (j * j + k * k <= 16) {
          voxels.push_back({i, 10 + j, 10 + k});
        }
      }
    }
  }
  const auto line = centrelineOf(maskOf({60, 21, 21}, voxels));
  ASSERT_GE(line.size(), 45U);
  EXPECT_LE(line.size(), 60U);
  for (const Index3& v : line) {
    if (v[0] > 4 && v[0] < 55) {  // at its flat ends the line may run to the rim
      EXPECT_LE(std::abs(v[1] - 10) + std::abs(v[2] - 10), 1);
    }
  }
}

TEST(Centreline, KeepsTheTopologyOfAnyMask) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 60; ++trial) {
    const Index3 size{10, 9, 8};
    const Mask mask = randomMask(random, size, 10 + static_cast<unsigned>(random() % 85));
    const auto line = centrelineOf(mask);
    const Mask thin = maskOf(size, line);
    EXPECT_EQ(eulerNumbers(thin).facesEdgesCorners, eulerNumbers(mask).facesEdgesCorners);
    EXPECT_EQ(piecesOf(thin, Neighbours::TwentySix).count(), piecesOf(mask, Neighbours::TwentySix).count());
    EXPECT_EQ(differenceOf(thin, mask).count(), 0U);
  }
}

TEST(Centreline, ABranchReachesTheEndOfEachArm) {
  std::vector<Index3> voxels;
  for (int n = 0; n < 30; ++n) {
    for (int a = -2; a <= 2; ++a) {
      for (int b = -2; b <= 2; ++b) {
        voxels.push_back({20 + n, 20 + a, 20 + b});
        voxels.push_back({20 + a, 20 + n, 20 + b});
        voxels.push_back({20 + a, 20 + b, 20 - std::min(n, 16)});
      }
    }
  }
  const auto line = centrelineOf(maskOf({52, 52, 24}, voxels));
  const auto highest = [&](std::size_t axis) {
    return (*std::max_element(line.begin(), line.end(), [&](const Index3& x, const Index3& y) { return x[axis] < y[axis]; }))[axis];
  };
  EXPECT_GE(highest(0), 45);
  EXPECT_GE(highest(1), 45);
  EXPECT_LE(line.size(), 110U);
}

}  // namespace
}  // namespace glisson
