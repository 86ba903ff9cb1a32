#include "reconstruction/image/liver_voxels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "reconstruction/errors.h"

namespace glisson {
namespace {

using Inside = std::function<bool(const Vec3&)>;

struct NamedBody {
  std::string name;
  StructureKind kind;
  Inside inside;
};

ImageGeometry grid() {
  ImageGeometry g;
  g.size = {64, 64, 40};
  g.spacing = Vec3(1, 1, 1.6);
  g.origin = Vec3(-31.5, -31.5, -31.2);
  return g;
}

Segmentation segmentationOf(const std::vector<NamedBody>& bodies) {
  Segmentation segmentation;
  segmentation.geometry = grid();
  segmentation.source = "bodies";
  const Index3 size = segmentation.geometry.size;
  for (const NamedBody& body : bodies) {
    std::vector<std::uint8_t> values;
    for (int k = 0; k < size[2]; ++k) {
      for (int j = 0; j < size[1]; ++j) {
        for (int i = 0; i < size[0]; ++i) {
          values.push_back(body.inside(segmentation.geometry.toWorld(Vec3(i, j, k))) ? 1 : 0);
        }
      }
    }
    LabelledMask structure;
    structure.name = body.name;
    structure.kind = body.kind;
    structure.mask = std::make_shared<const Mask>(Mask::fromGrid(size, values));
    segmentation.structures.push_back(std::move(structure));
  }
  return segmentation;
}

/// As a label map would hold it: every voxel of the liver that another structure has is taken from it.
Segmentation exclusive(Segmentation segmentation) {
  Mask liver = *segmentation.structures[0].mask;
  for (std::size_t n = 1; n < segmentation.structures.size(); ++n) {
    liver = differenceOf(liver, *segmentation.structures[n].mask);
  }
  segmentation.structures[0].mask = std::make_shared<const Mask>(liver);
  return segmentation;
}

Inside ball(const Vec3& centre, double radius) {
  return [=](const Vec3& p) { return (p - centre).norm() <= radius; };
}

/// A vein along a line from the liver's middle out through its surface, far beyond it.
Inside trunk(const Vec3& direction, double radius) {
  const Vec3 unit = direction.normalized();
  return [=](const Vec3& p) { return unit.dot(p) >= 0 && (p - unit * unit.dot(p)).norm() <= radius; };
}

bool equal(const Mask& a, const Mask& b) {
  return a.box() == b.box() && std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end());
}

bool mentions(const LiverVoxels& voxels, const std::string& text) {
  return std::any_of(voxels.notes.begin(), voxels.notes.end(),
                     [&](const std::string& note) { return note.find(text) != note.npos; });
}

const NamedBody kLiver{"liver", StructureKind::Liver, ball(Vec3::Zero(), 25)};

TEST(LiverVoxels, NestedAndExclusivePatientsAreTheSame) {
  for (const Vec3& way : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, -2, 3)}) {
    const Segmentation nested = segmentationOf({kLiver,
                                                {"portal vein", StructureKind::PortalVein, trunk(way, 3)},
                                                {"hepatic vein", StructureKind::HepaticVein, trunk(Vec3(-1, 1, 2), 4)},
                                                {"tumour", StructureKind::Tumour, ball(Vec3(-12, 0, 0), 6)},
                                                {"cyst", StructureKind::Cyst, ball(Vec3(0, -20, 0), 4)}});
    const LiverVoxels a = liverVoxels(nested);
    const LiverVoxels b = liverVoxels(exclusive(nested));
    EXPECT_TRUE(equal(a.liver, b.liver));
    EXPECT_TRUE(equal(a.tumour, b.tumour));
    EXPECT_TRUE(equal(a.functional, b.functional));
    EXPECT_NEAR(a.totalMl(), volumeMl(*nested.structures[0].mask, grid()), 0.003 * a.totalMl()) << "what was cut out is back";
    EXPECT_LT(volumeMl(*exclusive(nested).structures[0].mask, grid()), 0.97 * a.totalMl());
  }
}

TEST(LiverVoxels, TrunkOutsideTheLiverIsNotLiver) {
  const LiverVoxels voxels =
      liverVoxels(exclusive(segmentationOf({kLiver, {"portal vein", StructureKind::PortalVein, trunk(Vec3::UnitZ(), 4)}})));
  const ImageGeometry g = grid();
  for (int k = 0; k < g.size[2]; ++k) {
    for (int j = 0; j < g.size[1]; ++j) {
      for (int i = 0; i < g.size[0]; ++i) {
        if (voxels.liver.at(i, j, k)) {
          ASSERT_LE(g.toWorld(Vec3(i, j, k)).norm(), 25.0);
        }
      }
    }
  }
}

TEST(LiverVoxels, TrunkIsCutFlushWithAFlatSurface) {
  const NamedBody block{"liver", StructureKind::Liver, [](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 20.1; }};
  const Segmentation nested = segmentationOf({block, {"portal vein", StructureKind::PortalVein, trunk(Vec3::UnitX(), 5)}});
  EXPECT_TRUE(equal(liverVoxels(exclusive(nested)).liver, *nested.structures[0].mask));
}

TEST(LiverVoxels, CavaInItsGrooveIsNotLiver) {
  const auto groove = [](const Vec3& p) { return std::abs(p[0]) < 5 && p[1] > 10; };
  const NamedBody liver{"liver", StructureKind::Liver, [=](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 20.1 && !groove(p); }};
  const Segmentation s =
      segmentationOf({liver, {"vena cava", StructureKind::VenaCava, [=](const Vec3& p) { return groove(p) && p[1] < 20; }}});
  EXPECT_TRUE(equal(liverVoxels(s).liver, *s.structures[0].mask));
}

TEST(LiverVoxels, FunctionalAndTumourShareTheLiver) {
  const LiverVoxels voxels = liverVoxels(segmentationOf({kLiver,
                                                         {"tumour", StructureKind::Tumour, ball(Vec3(10, 0, 0), 6)},
                                                         {"cyst", StructureKind::Cyst, ball(Vec3(14, 0, 0), 6)}}));
  EXPECT_EQ(voxels.liver.count(), voxels.functional.count() + intersectionOf(voxels.tumour, voxels.liver).count());
  EXPECT_TRUE(intersectionOf(voxels.functional, voxels.tumour).empty());
  EXPECT_NEAR(voxels.totalMl(), 4.0 / 3 * std::numbers::pi * 15.625, 0.01 * 65);
  EXPECT_TRUE(mentions(voxels, "tumour and cyst overlap by 0.")) << "overlaps are listed and counted once";
}

TEST(LiverVoxels, DetachedLesionIsListedAndNotInTheLiver) {
  const LiverVoxels voxels = liverVoxels(segmentationOf(
      {{"liver", StructureKind::Liver, ball(Vec3(-8, 0, 0), 15)}, {"tumour", StructureKind::Tumour, ball(Vec3(20, 0, 0), 4)}}));
  EXPECT_GT(voxels.tumour.count(), 100U);
  EXPECT_TRUE(intersectionOf(voxels.tumour, voxels.liver).empty());
  EXPECT_TRUE(mentions(voxels, "tumour: 0.2")) << "0.26 mL";
  EXPECT_TRUE(mentions(voxels, "do not touch the liver"));
}

TEST(LiverVoxels, OneMaskOfSeveralTumoursIsJudgedPieceByPiece) {
  const auto both = [](const Vec3& p) { return ball(Vec3(-12, 0, 0), 4)(p) || ball(Vec3(24, 0, 0), 4)(p); };
  const Segmentation s =
      segmentationOf({{"liver", StructureKind::Liver, ball(Vec3(-8, 0, 0), 15)}, {"tumours", StructureKind::Tumour, both}});
  const LiverVoxels voxels = liverVoxels(exclusive(s));
  EXPECT_TRUE(equal(voxels.liver, *s.structures[0].mask));
  EXPECT_TRUE(mentions(voxels, "lie outside the liver mask"));
  EXPECT_TRUE(mentions(voxels, "do not touch the liver"));
}

TEST(LiverVoxels, LesionThatTouchesByACornerBelongsToTheLiver) {
  const auto at = [](const Vec3& index) {
    const Vec3 world = grid().toWorld(index);
    return [world](const Vec3& p) { return (p - world).norm() < 0.1; };
  };
  EXPECT_EQ(liverVoxels(segmentationOf({{"liver", StructureKind::Liver, at(Vec3(10, 10, 10))},
                                        {"tumour", StructureKind::Tumour, at(Vec3(11, 11, 11))}}))
                .liver.count(),
            2U);
  EXPECT_EQ(liverVoxels(segmentationOf({{"liver", StructureKind::Liver, at(Vec3(10, 10, 10))},
                                        {"tumour", StructureKind::Tumour, at(Vec3(12, 11, 11))}}))
                .liver.count(),
            1U);
}

TEST(LiverVoxels, LiverAtTheBorderOfTheGridIsTakenWhole) {
  const Segmentation nested = segmentationOf({{"liver", StructureKind::Liver, [](const Vec3&) { return true; }},
                                              {"portal vein", StructureKind::PortalVein, trunk(Vec3::UnitZ(), 4)},
                                              {"tumour", StructureKind::Tumour, ball(Vec3(31, 31, 31), 5)}});
  EXPECT_EQ(liverVoxels(exclusive(nested)).liver.count(), grid().voxelCount());
}

TEST(LiverVoxels, NoLiverOrAnEmptyOneIsRefused) {
  EXPECT_THROW(liverVoxels(segmentationOf({{"tumour", StructureKind::Tumour, ball(Vec3::Zero(), 5)}})), ReconstructionError);
  EXPECT_THROW(liverVoxels(segmentationOf({{"liver", StructureKind::Liver, [](const Vec3&) { return false; }}})),
               ReconstructionError);
}

}  // namespace
}  // namespace glisson
