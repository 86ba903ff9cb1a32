// Two thousand random label maps through Poisson reconstruction: blobs, tubes, thin sheets, single voxels, voxels that touch by an
// edge or a corner, several components, cavities, contact with the image's border, anisotropy up to 5, oblique and left-handed
// directions. Each at one random depth of 5 to 8; at every depth where GLISSON_LONG_TESTS is set.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/mask_pieces.h"
#include "reconstruction/reconstruct.h"
#include "tests/support/real_data.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

constexpr int kMaps = test::trials(2000);
constexpr int kParts = 4;  // so that they run beside each other

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  int upTo(int most) { return static_cast<int>(random_() % static_cast<unsigned>(most + 1)); }
  bool oneIn(int n) { return upTo(n - 1) == 0; }
  double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967295.0; }

 private:
  std::mt19937 random_;
};

ImageGeometry randomGrid(Chance& chance) {
  ImageGeometry geometry;
  geometry.size = {10 + chance.upTo(14), 10 + chance.upTo(14), 6 + chance.upTo(14)};
  const double plane = chance.between(0.5, 1.0);
  geometry.spacing = Vec3(plane, plane, plane * chance.between(0.5, 5.0));
  geometry.origin = Vec3(chance.between(-300, 300), chance.between(-300, 300), chance.between(-900, 900));
  const Eigen::AngleAxisd turn(chance.between(0, std::numbers::pi),
                               Vec3(chance.between(-1, 1), chance.between(-1, 1), chance.between(0.1, 1)).normalized());
  if (chance.oneIn(2)) {
    geometry.direction = turn.toRotationMatrix();
  }
  if (chance.oneIn(2)) {
    geometry.direction.col(chance.upTo(2)) *= -1;
  }
  return geometry;
}

/// What a part of a map looks like, in voxels about its centre.
bool holds(int shape, const Vec3& q, double reach, Chance& chance) {
  switch (shape) {
    case 0:
      return q.norm() <= reach;  // blob
    case 1:
      return std::hypot(q[0], q[1]) <= 0.4 * reach;  // tube along an axis
    case 2:
      return std::abs(q[1] - 0.4 * q[0]) <= 0.6;  // slanted sheet a voxel thick
    case 3:
      return q.norm() <= reach && q.norm() > 0.5 * reach;  // shell with a cavity
    case 4:
      return q.cwiseAbs().maxCoeff() <= reach && chance.oneIn(4);  // voxels that touch anyhow
    default:
      return q.cwiseAbs().maxCoeff() < 0.5;  // one voxel
  }
}

Mask randomMask(const ImageGeometry& geometry, Chance& chance) {
  std::vector<std::uint8_t> values(geometry.voxelCount(), 0);
  for (int parts = 1 + chance.upTo(4); parts > 0; --parts) {
    const int shape = chance.upTo(5);
    const double reach = chance.between(1.0, 6.0);
    Vec3 centre;
    for (std::size_t a = 0; a < 3; ++a) {
      centre[static_cast<Eigen::Index>(a)] = chance.upTo(geometry.size[a] - 1);
    }
    std::size_t n = 0;
    for (int k = 0; k < geometry.size[2]; ++k) {
      for (int j = 0; j < geometry.size[1]; ++j) {
        for (int i = 0; i < geometry.size[0]; ++i, ++n) {
          values[n] = holds(shape, Vec3(i, j, k) - centre, reach, chance) ? 1 : values[n];
        }
      }
    }
  }
  return Mask::fromGrid(geometry.size, values);
}

bool says(const Reconstruction& made, const std::string& word) {
  return std::ranges::any_of(made.notes, [&](const std::string& note) { return note.find(word) != std::string::npos; });
}

void expectSoundAndHonest(const Mask& mask, const ImageGeometry& geometry, int depth, Sampling sampling, const std::string& what) {
  ReconstructionParameters parameters;
  parameters.psr.depth = depth;
  parameters.psr.sampling = sampling;
  Reconstruction made;
  try {
    made = reconstruct(mask, geometry, StructureKind::Other, parameters);
  } catch (const ReconstructionError& error) {
    EXPECT_EQ(sampling, Sampling::Paper) << what << ": " << error.what();  // single voxels have no gradient
    return;
  }
  for (const auto& name : made.defects.names()) {
    // The few paper points of a handful of voxels may look inward all of them; that is a defect and named.
    EXPECT_TRUE(sampling == Sampling::Paper && name == "orientation: inward") << what << ": " << name;
  }
  EXPECT_EQ(made.meshVolumeMl > 0, made.defects.names().empty()) << what;
  std::uint32_t walls = 0;
  componentOfTriangles(made.mesh, walls);
  // Those that are none by a corner either: what touches the outside by a corner may open to it.
  const std::size_t cavities = cavitiesOf(mask, Neighbours::TwentySix).count();
  EXPECT_EQ(made.maskComponents, piecesOf(mask, Neighbours::TwentySix).count()) << what;
  EXPECT_TRUE(made.meshComponents >= made.maskComponents || says(made, "piece")) << what << ": a lost piece is not named";
  EXPECT_TRUE(walls >= made.meshComponents + cavities || says(made, "cavit")) << what << ": a lost cavity is not named";
}

class RandomLabelMaps : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Parts, RandomLabelMaps, testing::Range(0, kParts));

TEST_P(RandomLabelMaps, GiveSoundMeshesThatNameWhatTheyLack) {
  const bool everyDepth = test::longRuns();
  for (int map = GetParam(); map < kMaps; map += kParts) {
    Chance chance(20160000U + static_cast<unsigned>(map));
    const ImageGeometry geometry = randomGrid(chance);
    const Mask mask = randomMask(geometry, chance);
    const int depth = 5 + chance.upTo(3);
    const Sampling sampling = chance.oneIn(5) ? Sampling::Paper : Sampling::Unbiased;
    for (int d = 5; d <= 8 && !mask.empty(); ++d) {
      if (d == depth || everyDepth) {
        expectSoundAndHonest(mask, geometry, d, sampling, "map " + std::to_string(map) + " at depth " + std::to_string(d));
      }
    }
  }
}

}  // namespace
}  // namespace glisson
