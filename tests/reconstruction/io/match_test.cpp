// Labels on the CT's grid and of its patient (hazards H1, H2), and the options of the command line.

#include <gtest/gtest.h>

#include <algorithm>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "tests/reconstruction/io/fixtures.h"

namespace glisson {
namespace {

using namespace fixtures;

CtVolume ctOn(const ImageGeometry& geometry) {
  CtVolume ct;
  ct.geometry = geometry;
  ct.hounsfield.assign(geometry.voxelCount(), 0);
  ct.source = "ct";
  return ct;
}

Segmentation bodyOn(const ImageGeometry& geometry) {
  Segmentation segmentation;
  segmentation.geometry = geometry;
  segmentation.source = "labels";
  LabelledMask body;
  body.name = "liver";
  body.mask = std::make_shared<const Mask>(Mask::fromGrid(geometry.size, asymmetricBody(geometry)));
  segmentation.structures.push_back(body);
  return segmentation;
}

TEST(MatchToCt, TheSameGridKeepsTheSameMasks) {
  const ImageGeometry geometry = permutedGrid(3, 15);
  const Segmentation labels = bodyOn(geometry);
  const Segmentation matched = matchToCt(labels, ctOn(geometry));
  EXPECT_EQ(matched.structures[0].mask, labels.structures[0].mask);
}

TEST(MatchToCt, H1TheSameVoxelsCountedAlongOtherAxesAreReorderedExactly) {
  ImageGeometry labels = permutedGrid(0, 25);
  for (const Index3& order : {Index3{0, 1, 2}, Index3{1, 0, 2}, Index3{2, 0, 1}, Index3{1, 2, 0}}) {
    for (int flips = 0; flips < 8; ++flips) {
      ImageGeometry grid = labels;
      Vec3 corner = Vec3::Zero();
      for (std::size_t a = 0; a < 3; ++a) {
        const auto to = static_cast<Eigen::Index>(a);
        const auto from = static_cast<Eigen::Index>(order[a]);
        const bool flipped = ((flips >> a) & 1) != 0;
        grid.size[a] = labels.size[static_cast<std::size_t>(from)];
        grid.spacing[to] = labels.spacing[from];
        grid.direction.col(to) = (flipped ? -1 : 1) * labels.direction.col(from);
        corner[from] = flipped ? labels.size[static_cast<std::size_t>(from)] - 1 : 0;
      }
      grid.origin = labels.toWorld(corner);
      const Segmentation matched = matchToCt(bodyOn(labels), ctOn(grid));
      EXPECT_LE(matched.geometry.cornerDistance(grid), 1e-9);
      const Mask expected = Mask::fromGrid(grid.size, asymmetricBody(grid));
      EXPECT_EQ(matched.structures[0].mask->box(), expected.box());
      EXPECT_TRUE(std::ranges::equal(matched.structures[0].mask->values(), expected.values()));
    }
  }
}

/// `grid` with some of its outer voxels taken off.
ImageGeometry cropOf(const ImageGeometry& grid, const Index3& low, const Index3& high) {
  ImageGeometry crop = grid;
  crop.origin = grid.toWorld(Vec3(low[0], low[1], low[2]));
  for (std::size_t a = 0; a < 3; ++a) {
    crop.size[a] -= low[a] + high[a];
  }
  return crop;
}

bool says(const std::vector<std::string>& notes, const std::string& what) {
  return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(what) != std::string::npos; });
}

TEST(MatchToCt, H1ACropOfTheSameVoxelsLiesWhereItsVoxelsLie) {
  const ImageGeometry labels = permutedGrid(0, 25);
  const Segmentation body = bodyOn(labels);
  const Mask& mask = *body.structures[0].mask;
  // around the labels' grid a larger one on the same lattice, and that one counted backwards along j
  const Index3 low{3, 0, 2};
  ImageGeometry larger = cropOf(labels, {-low[0], -low[1], -low[2]}, {-1, -4, 0});
  ImageGeometry backwards = larger;
  backwards.origin = larger.toWorld(Vec3(0, larger.size[1] - 1, 0));
  backwards.direction.col(1) *= -1;
  for (const ImageGeometry& grid : {larger, backwards}) {
    const Segmentation matched = matchToCt(body, ctOn(grid));
    EXPECT_EQ(matched.geometry.size, grid.size);
    ASSERT_EQ(matched.structures[0].mask->count(), mask.count());
    for (int k = 0; k < labels.size[2]; ++k) {
      for (int j = 0; j < labels.size[1]; ++j) {
        for (int i = 0; i < labels.size[0]; ++i) {
          const Vec3 at = grid.toIndex(labels.toWorld(Vec3(i, j, k))).array().round();
          ASSERT_EQ(matched.structures[0].mask->at(static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])),
                    mask.at(i, j, k));
        }
      }
    }
    EXPECT_TRUE(says(matched.notes, "part of the CT's grid"));
  }
}

TEST(MatchToCt, ACropThatCutsAStructureSaysSoAndOneOffTheLatticeOrTheCtIsRefused) {
  const ImageGeometry grid = permutedGrid(0, 25);
  const IndexBox box = bodyOn(grid).structures[0].mask->box();
  const Segmentation cut = bodyOn(cropOf(grid, {box.first[0] + 1, 0, 0}, {0, 0, 0}));
  const Segmentation matched = matchToCt(cut, ctOn(grid));
  EXPECT_TRUE(says(matched.notes, "may be cut off there"));
  ImageGeometry shifted = cropOf(grid, {1, 1, 1}, {0, 0, 0});
  shifted.origin += 0.05 * grid.spacing;
  EXPECT_THROW(matchToCt(bodyOn(shifted), ctOn(grid)), InputError);
  const ImageGeometry outside = cropOf(grid, {-1, 1, 1}, {1, 0, 0});
  EXPECT_THROW(matchToCt(bodyOn(outside), ctOn(grid)), InputError);
}

TEST(MatchToCt, AnotherGridIsRefusedNamingBothAndResampledWithConsent) {
  const ImageGeometry labels = permutedGrid(0, 0);
  ImageGeometry grid = labels;
  grid.size = {27, 24, 21};
  grid.spacing /= 3;
  grid.origin -= labels.spacing / 3;
  try {
    matchToCt(bodyOn(labels), ctOn(grid));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("9x8x7"), std::string::npos) << message;
    EXPECT_NE(message.find("27x24x21"), std::string::npos) << message;
    EXPECT_NE(message.find("--accept resample-labels"), std::string::npos) << message;
  }
  ReadOptions options;
  parseConsents("resample-labels", options);
  const Segmentation source = bodyOn(labels);
  const Segmentation matched = matchToCt(source, ctOn(grid), options);
  EXPECT_EQ(matched.structures[0].mask->count(), 27 * source.structures[0].mask->count());
  EXPECT_EQ(matched.geometry.size, grid.size);
  for (const Index3& voxel : {Index3{4, 3, 3}, Index3{5, 3, 3}, Index3{4, 4, 5}, Index3{0, 0, 0}}) {
    EXPECT_EQ(matched.structures[0].mask->at(3 * voxel[0] + 1, 3 * voxel[1] + 1, 3 * voxel[2] + 1),
              source.structures[0].mask->at(voxel[0], voxel[1], voxel[2]));
  }
}

TEST(MatchToCt, H2AnotherPatientBlocksOnlyWhereBothIdsAreThere) {
  const ImageGeometry geometry = permutedGrid(0, 0);
  CtVolume ct = ctOn(geometry);
  Segmentation labels = bodyOn(geometry);
  labels.patientId = "A";
  EXPECT_NO_THROW(matchToCt(labels, ct));
  EXPECT_FALSE(matchToCt(labels, ct).notes.empty());
  ct.identity.patientId = "B";
  EXPECT_THROW(matchToCt(labels, ct), InputError);
  ReadOptions options;
  parseConsents("other-patient", options);
  const std::vector<std::string> notes = matchToCt(labels, ct, options).notes;
  ASSERT_EQ(notes.size(), 1U);  // what was accepted is not forgotten
  EXPECT_EQ(notes[0], "Labels of another patient than the CT's were taken with consent (their PatientID differ).");
  ct.identity.patientId = "A";
  EXPECT_TRUE(matchToCt(labels, ct).notes.empty());
  ct.identity.frameOfReferenceUid = "1";
  labels.frameOfReferenceUid = "2";
  EXPECT_THROW(matchToCt(labels, ct), InputError);
}

TEST(MatchToCt, H2TheRefusalNamesTheIdThatDiffersAndNoneOfItsValues) {
  const ImageGeometry geometry = permutedGrid(0, 0);
  const auto message = [&](const std::string& patient, const std::string& frame) {
    CtVolume ct = ctOn(geometry);
    ct.identity.patientName = "Canary^Name";
    ct.identity.patientId = "CANARY-A";
    ct.identity.frameOfReferenceUid = "1.2";
    Segmentation labels = bodyOn(geometry);
    labels.patientId = patient;
    labels.frameOfReferenceUid = frame;
    try {
      matchToCt(labels, ct);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string patient = message("CANARY-B", "1.2");
  EXPECT_NE(patient.find("PatientID"), std::string::npos) << patient;
  EXPECT_EQ(patient.find("FrameOfReferenceUID"), std::string::npos) << patient;
  EXPECT_EQ(patient.find("CANARY"), std::string::npos) << patient;
  EXPECT_EQ(patient.find("Canary"), std::string::npos) << patient;
  const std::string frame = message("CANARY-A", "1.3");
  EXPECT_EQ(frame.find("PatientID"), std::string::npos) << frame;
  EXPECT_NE(frame.find("FrameOfReferenceUID"), std::string::npos) << frame;
  const std::string both = message("CANARY-B", "1.3");
  EXPECT_NE(both.find("PatientID and FrameOfReferenceUID"), std::string::npos) << both;
  EXPECT_EQ(message("CANARY-A", "1.2"), "");
}

TEST(Options, LabelsAndConsentsAreParsedAndNonsenseIsUsage) {
  ReadOptions options;
  parseLabels("totalsegmentator-v1,5=liver,My = name=tumor,64=portal_vein", options);
  EXPECT_EQ(options.labelTable, "totalsegmentator-v1");
  EXPECT_EQ(options.kindByLabel.at(5), StructureKind::Liver);
  EXPECT_EQ(options.kindByLabel.at(64), StructureKind::PortalVein);
  EXPECT_EQ(options.kindByName.at("My = name"), StructureKind::Tumour);
  parseConsents("resample-labels,tilt,uneven-slices,other-patient", options);
  EXPECT_EQ(options.consents.size(), 4U);
  for (const char* text : {"", "5", "=liver", "5=spaceship", "totalsegmentator-v9"}) {
    EXPECT_THROW(parseLabels(text, options), UsageError) << text;
  }
  EXPECT_THROW(parseConsents("everything", options), UsageError);
}

}  // namespace
}  // namespace glisson
