// Two thousand random label maps through Poisson reconstruction: blobs, tubes, thin sheets, single voxels, voxels that touch by an
// edge or a corner, several components, cavities, contact with the image's border, anisotropy up to 5, oblique and left-handed
// directions; some long enough for the cells of depth 8, some screened, some at the automatic depth. Each at one random depth of 5
// to 8; at every depth where GLISSON_LONG_TESTS is set.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <random>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/mask_pieces.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/reconstruct.h"
#include "tests/support/real_data.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

const int kMaps = test::trials(2000);
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
  if (chance.oneIn(6)) {  // long enough for depth 7 and 8, so that their blocks are a narrow band
    geometry.size[static_cast<std::size_t>(chance.upTo(2))] = 120 + chance.upTo(80);
  }
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

/// What a part of a map looks like, in voxels about its centre. Tubes run along axis `along`.
bool holds(int shape, const Vec3& q, double reach, Eigen::Index along, Chance& chance) {
  switch (shape) {
    case 0:
      return q.norm() <= reach;  // blob
    case 1:
      return std::hypot(q[(along + 1) % 3], q[(along + 2) % 3]) <= 0.4 * reach;  // tube along an axis
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
  const auto along = static_cast<Eigen::Index>(std::ranges::max_element(geometry.size) - geometry.size.begin());
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
          values[n] = holds(shape, Vec3(i, j, k) - centre, reach, along, chance) ? 1 : values[n];
        }
      }
    }
  }
  return Mask::fromGrid(geometry.size, values);
}

bool says(const Reconstruction& made, const std::string& word) {
  return std::ranges::any_of(made.notes, [&](const std::string& note) { return note.find(word) != std::string::npos; });
}

/// Gives the depth that was used; 0 where there is no surface.
int expectSoundAndHonest(const Mask& mask, const ImageGeometry& geometry, const ReconstructionParameters& parameters,
                         const std::string& what) {
  const Sampling sampling = parameters.psr.sampling;
  Reconstruction made;
  try {
    made = reconstruct(mask, geometry, StructureKind::Other, parameters);
  } catch (const ReconstructionError& error) {
    EXPECT_EQ(sampling, Sampling::Paper) << what << ": " << error.what();  // single voxels have no gradient
    return 0;
  }
  for (const auto& name : made.defects.names()) {
    // The few paper points of a handful of voxels may look inward all of them; that is a defect and named.
    EXPECT_TRUE(sampling == Sampling::Paper && name == "orientation: inward") << what << ": " << name;
  }
  EXPECT_EQ(made.meshVolumeMl > 0, made.defects.names().empty()) << what;
  EXPECT_EQ(countSelfIntersections(made.mesh), 0U) << what;
  std::uint32_t walls = 0;
  componentOfTriangles(made.mesh, walls);
  // Those that are none by a corner either: what touches the outside by a corner may open to it.
  const std::size_t cavities = cavitiesOf(mask, Neighbours::TwentySix).count();
  EXPECT_EQ(made.maskComponents, piecesOf(mask, Neighbours::TwentySix).count()) << what;
  EXPECT_TRUE(made.meshComponents >= made.maskComponents || says(made, "piece")) << what << ": a lost piece is not named";
  EXPECT_TRUE(walls >= made.meshComponents + cavities || says(made, "cavit")) << what << ": a lost cavity is not named";
  // Those that are closed by faces alone: the mesh may close what touches the outside by a corner.
  const std::size_t mostCavities = cavitiesOf(mask, Neighbours::Six).count();
  EXPECT_TRUE(walls <= made.meshComponents + mostCavities || says(made, "cavit")) << what << ": a cavity too many is not named";
  return made.usedDepth;
}

class RandomLabelMaps : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Parts, RandomLabelMaps, testing::Range(0, kParts));

TEST_P(RandomLabelMaps, GiveSoundMeshesThatNameWhatTheyLack) {
  const bool everyDepth = test::longRuns();
  std::map<int, int> mapsOfDepth;
  for (int map = GetParam(); map < kMaps; map += kParts) {
    Chance chance(20160000U + static_cast<unsigned>(map));
    const ImageGeometry geometry = randomGrid(chance);
    const Mask mask = randomMask(geometry, chance);
    ReconstructionParameters parameters;
    const int depth = 5 + chance.upTo(3);
    parameters.psr.sampling = chance.oneIn(5) ? Sampling::Paper : Sampling::Unbiased;
    parameters.psr.pointWeight = chance.oneIn(6) ? chance.between(1, 16) : 0;
    parameters.autoDepth = chance.oneIn(12);
    for (int d = 5; d <= 8 && !mask.empty(); ++d) {
      if (d == depth || (everyDepth && !parameters.autoDepth)) {
        parameters.psr.depth = d;
        ++mapsOfDepth[expectSoundAndHonest(mask, geometry, parameters,
                                           "map " + std::to_string(map) + " at depth " + std::to_string(d))];
      }
    }
  }
  if (kMaps >= 2000) {
    for (const int depth : {5, 6, 7, 8}) {
      EXPECT_GE(mapsOfDepth[depth], 10) << "maps that use depth " << depth;
    }
  }
}

}  // namespace
}  // namespace glisson
