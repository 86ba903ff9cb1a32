// The sample patient: repeatable, realistic, connected, and as large as its truth says. The truth is checked by a quadrature of its
// own.
#include "reconstruction/sample/sample_patient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/sample/vessel_tree.h"

namespace glisson {
namespace {

const SamplePatient& patient(bool thin) {
  if (thin) {
    static const SamplePatient kThin = makeSamplePatient(true);
    return kThin;
  }
  static const SamplePatient kThick = makeSamplePatient(false);
  return kThick;
}

const Mask& maskOf(const SamplePatient& of, const std::string& name) {
  for (const LabelledMask& structure : of.segmentation.structures) {
    if (structure.name == name) {
      return *structure.mask;
    }
  }
  throw std::runtime_error("no structure " + name);
}

/// 26-connected components.
int componentsOf(const Mask& mask) {
  const IndexBox& box = mask.box();
  std::vector<std::uint8_t> left(mask.values().begin(), mask.values().end());
  const auto offset = [&](int i, int j, int k) {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(box.size[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k));
  };
  int components = 0;
  std::deque<Index3> front;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i) {
        if (left[offset(i, j, k)] == 0) {
          continue;
        }
        ++components;
        left[offset(i, j, k)] = 0;
        front.push_back({i, j, k});
        while (!front.empty()) {
          const Index3 at = front.front();
          front.pop_front();
          for (int n = 0; n < 27; ++n) {
            const Index3 to{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1};
            const bool inBox =
                to[0] >= 0 && to[1] >= 0 && to[2] >= 0 && to[0] < box.size[0] && to[1] < box.size[1] && to[2] < box.size[2];
            if (inBox && left[offset(to[0], to[1], to[2])] != 0) {
              left[offset(to[0], to[1], to[2])] = 0;
              front.push_back(to);
            }
          }
        }
      }
    }
  }
  return components;
}

/// Two masks have voxels that are the same or neighbours (26).
bool touch(const Mask& a, const Mask& b) {
  const IndexBox& box = a.box();
  std::size_t n = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i, ++n) {
        if (a.values()[n] == 0) {
          continue;
        }
        for (int m = 0; m < 27; ++m) {
          if (b.at(box.first[0] + i + m % 3 - 1, box.first[1] + j + m / 3 % 3 - 1, box.first[2] + k + m / 9 - 1)) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

double ml(const SamplePatient& of, const std::string& name) {
  return static_cast<double>(maskOf(of, name).count()) * of.ct.geometry.voxelVolumeMm3() * 1e-3;
}

/// Volume in mL by midpoints on a grid that shares nothing with the voxels.
template <typename Distance>
double quadratureMl(const Vec3& low, const Vec3& high, double step, const Distance& distance) {
  const auto slices = static_cast<std::size_t>((high[2] - low[2]) / step);
  std::vector<std::size_t> inside(slices);
  parallelFor(slices, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double z = low[2] + (static_cast<double>(k) + 0.5) * step;
      for (double y = low[1] + 0.5 * step; y < high[1]; y += step) {
        for (double x = low[0] + 0.5 * step; x < high[0]; x += step) {
          inside[k] += distance(Vec3(x, y, z)) < 0 ? 1 : 0;
        }
      }
    }
  });
  std::size_t sum = 0;
  for (const std::size_t n : inside) {
    sum += n;
  }
  return static_cast<double>(sum) * step * step * step * 1e-3;
}

/// Points of a square grid in the plane z that lie in the tree.
std::size_t pointsInSlice(const sample::VesselTree& tree, double z, double step) {
  constexpr int kHalf = 300;
  std::vector<bool> inside(std::size_t{4} * kHalf * kHalf);  // a point in two branches counts once
  for (const sample::Branch& branch : tree.branches) {
    const sample::Capsule& c = branch.shape;
    const double radius = std::max(c.fromRadius, c.toRadius);
    const Vec3 low = c.from.cwiseMin(c.to) - Vec3::Constant(radius);
    const Vec3 high = c.from.cwiseMax(c.to) + Vec3::Constant(radius);
    if (z < low[2] || z > high[2]) {
      continue;
    }
    for (int j = static_cast<int>(low[1] / step) - 1; j * step < high[1]; ++j) {
      for (int i = static_cast<int>(low[0] / step) - 1; i * step < high[0]; ++i) {
        if (sample::signedDistance(c, Vec3(i * step, j * step, z)) < 0) {
          inside[std::size_t{2} * kHalf * static_cast<std::size_t>(j + kHalf) + static_cast<std::size_t>(i + kHalf)] = true;
        }
      }
    }
  }
  return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), true));
}

class SamplePatientTest : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Slices, SamplePatientTest, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& slices) { return slices.param ? "thin" : "thick"; });

TEST_P(SamplePatientTest, GridHasTheStatedSpacingAndAnOriginOffZero) {
  const ImageGeometry& geometry = patient(GetParam()).ct.geometry;
  EXPECT_DOUBLE_EQ(geometry.spacing[0], 0.78);
  EXPECT_DOUBLE_EQ(geometry.spacing[1], 0.78);
  EXPECT_DOUBLE_EQ(geometry.spacing[2], GetParam() ? 0.8 : 2.5);
  EXPECT_GT(geometry.origin.cwiseAbs().minCoeff(), 10);
  EXPECT_EQ(patient(GetParam()).ct.hounsfield.size(), geometry.voxelCount());
  EXPECT_LT(patient(GetParam()).segmentation.geometry.cornerDistance(geometry), 1e-12);
}

TEST_P(SamplePatientTest, MasksAgreeWithTheTruth) {
  const SamplePatient& sample = patient(GetParam());
  const auto deviation = [&](const std::string& name, double truth) { return std::abs(ml(sample, name) / truth - 1); };
  EXPECT_LT(deviation("liver", sample.truth.liverMl), 0.001);
  EXPECT_LT(deviation("portal vein", sample.truth.portalVeinMl), 0.05);
  EXPECT_LT(deviation("hepatic vein", sample.truth.hepaticVeinMl), 0.05);
  EXPECT_LT(deviation("gallbladder", sample.truth.gallbladderMl), 0.02);
  ASSERT_EQ(sample.truth.tumourMl.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_LT(deviation("tumour " + std::to_string(n + 1), sample.truth.tumourMl[n]), 0.02) << n;
  }
}

TEST_P(SamplePatientTest, TruthOfTheTreesIsTheVolumeOfTheirBranches) {
  const sample::VesselTrees trees = sample::growVessels(GetParam() ? 1.0 : 1.5);
  const auto volume = [](const sample::VesselTree& tree) {
    constexpr double kStep = 0.47;
    std::vector<std::size_t> inside(400);
    parallelFor(inside.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        inside[n] = pointsInSlice(tree, -85 + kStep * static_cast<double>(n), kStep);
      }
    });
    return static_cast<double>(std::accumulate(inside.begin(), inside.end(), std::size_t{0})) * kStep * kStep * kStep * 1e-3;
  };
  EXPECT_NEAR(volume(trees.portal) / patient(GetParam()).truth.portalVeinMl, 1, 0.003);
  EXPECT_NEAR(volume(trees.hepatic) / patient(GetParam()).truth.hepaticVeinMl, 1, 0.003);
}

TEST_P(SamplePatientTest, EachStructureIsOnePiece) {
  for (const LabelledMask& structure : patient(GetParam()).segmentation.structures) {
    EXPECT_EQ(componentsOf(*structure.mask), 1) << structure.name;
    EXPECT_FALSE(structure.mask->touchesBorder(patient(GetParam()).ct.geometry.size)) << structure.name;
  }
}

TEST_P(SamplePatientTest, VesselsTumoursAndGallbladderDoNotTouchOneAnother) {
  const auto& structures = patient(GetParam()).segmentation.structures;
  for (std::size_t a = 1; a < structures.size(); ++a) {
    for (std::size_t b = a + 1; b < structures.size(); ++b) {
      EXPECT_FALSE(touch(*structures[a].mask, *structures[b].mask)) << structures[a].name << ", " << structures[b].name;
    }
  }
}

TEST_P(SamplePatientTest, LiverHoldsTheTumoursAndNoGallbladder) {
  const Mask& liver = maskOf(patient(GetParam()), "liver");
  for (int n = 1; n <= 3; ++n) {
    EXPECT_TRUE(differenceOf(maskOf(patient(GetParam()), "tumour " + std::to_string(n)), liver).empty());
  }
  EXPECT_TRUE(intersectionOf(maskOf(patient(GetParam()), "gallbladder"), liver).empty());
}

TEST_P(SamplePatientTest, TrunksOfBothTreesLeaveTheLiver) {
  const Mask& liver = maskOf(patient(GetParam()), "liver");
  for (const char* name : {"portal vein", "hepatic vein"}) {
    EXPECT_FALSE(differenceOf(maskOf(patient(GetParam()), name), liver).empty()) << name;
    EXPECT_FALSE(intersectionOf(maskOf(patient(GetParam()), name), liver).empty()) << name;
  }
}

TEST_P(SamplePatientTest, TreesBranchAtLeastFiveTimesDownToTheStatedDiameter) {
  const double tip = GetParam() ? 1.0 : 1.5;
  const sample::VesselTrees trees = sample::growVessels(tip);
  for (const sample::VesselTree* tree : {&trees.portal, &trees.hepatic}) {
    EXPECT_GE(tree->generations(), 5);
    double thinnest = 1e9;
    for (const sample::Branch& branch : tree->branches) {
      thinnest = std::min(thinnest, branch.shape.toRadius);
      EXPECT_GE(branch.shape.fromRadius + (branch.parent < 0 ? 1 : 0), branch.shape.toRadius);
    }
    EXPECT_DOUBLE_EQ(thinnest, tip);
  }
  EXPECT_EQ(patient(GetParam()).truth.portalBranchPoints.size(), trees.portal.branchPoints().size());
  EXPECT_EQ(patient(GetParam()).truth.hepaticBranchPoints.size(), trees.hepatic.branchPoints().size());
}

TEST_P(SamplePatientTest, BranchPointsLieInTheirTreesMask) {
  const SamplePatient& sample = patient(GetParam());
  const auto check = [&](const std::vector<Vec3>& points, const Mask& mask) {
    for (const Vec3& p : points) {
      const Vec3 index = sample.ct.geometry.toIndex(p);
      EXPECT_TRUE(mask.at(static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
                          static_cast<int>(std::lround(index[2]))))
          << p.transpose();
    }
  };
  check(sample.truth.portalBranchPoints, maskOf(sample, "portal vein"));
  check(sample.truth.hepaticBranchPoints, maskOf(sample, "hepatic vein"));
}

TEST_P(SamplePatientTest, CtHasTheTissuesHounsfieldUnitsAndNoise) {
  const SamplePatient& sample = patient(GetParam());
  const auto statistics = [&](const Mask& mask, double& mean, double& deviation) {
    const IndexBox& box = mask.box();
    double sum = 0;
    double squares = 0;
    std::size_t n = 0;
    for (int k = 0; k < box.size[2]; ++k) {
      for (int j = 0; j < box.size[1]; ++j) {
        for (int i = 0; i < box.size[0]; ++i, ++n) {
          if (mask.values()[n] != 0) {
            const Index3& size = sample.ct.geometry.size;
            const double hu =
                sample.ct.hounsfield[static_cast<std::size_t>(box.first[0] + i) +
                                     static_cast<std::size_t>(size[0]) *
                                         (static_cast<std::size_t>(box.first[1] + j) +
                                          static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(box.first[2] + k))];
            sum += hu;
            squares += hu * hu;
          }
        }
      }
    }
    const auto count = static_cast<double>(mask.count());
    mean = sum / count;
    deviation = std::sqrt(squares / count - mean * mean);
  };
  double mean = 0;
  double deviation = 0;
  statistics(maskOf(sample, "tumour 1"), mean, deviation);
  EXPECT_NEAR(mean, 62, 6);
  EXPECT_GT(deviation, 8);
  EXPECT_LT(deviation, 16);
  statistics(maskOf(sample, "gallbladder"), mean, deviation);
  EXPECT_NEAR(mean, 8, 8);
  statistics(maskOf(sample, "liver"), mean, deviation);
  EXPECT_GT(mean, 100);
  EXPECT_LT(mean, 115);
  statistics(maskOf(sample, "hepatic vein"), mean, deviation);
  EXPECT_GT(mean, 150);
  EXPECT_LT(mean, 175);
}

TEST(SamplePatient, TruthOfTheLiverIsItsVolumeByAFinerQuadrature) {
  const double liver = quadratureMl({-130, -86, -76}, {100, 80, 86}, 0.71, sample::liverDistance);
  EXPECT_NEAR(liver / patient(false).truth.liverMl, 1, 2e-4);
  EXPECT_NEAR(liver / patient(true).truth.liverMl, 1, 2e-4);
  const double gallbladder = quadratureMl({-62, -60, -82}, {-18, 14, -34}, 0.31, sample::gallbladderDistance);
  EXPECT_NEAR(gallbladder / patient(false).truth.gallbladderMl, 1, 2e-3);
}

TEST(SamplePatient, LiverIsOnThePatientsRightWithTheLargerRightLobe) {
  const SamplePatient& sample = patient(false);
  const Mask& liver = maskOf(sample, "liver");
  const IndexBox& box = liver.box();
  std::size_t right = 0;
  std::size_t n = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i, ++n) {
        const double x = sample.ct.geometry.toWorld(Vec3(box.first[0] + i, box.first[1] + j, box.first[2] + k))[0];
        right += liver.values()[n] != 0 && x < 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(static_cast<double>(right), 0.6 * static_cast<double>(liver.count()));
  EXPECT_GT(sample.truth.liverMl, 1300);
  EXPECT_LT(sample.truth.liverMl, 1700);
}

TEST(SamplePatient, IsTheSameOnOneThreadAndOnAll) {
  const ThreadLimit one(1);
  const SamplePatient again = makeSamplePatient(false);
  const SamplePatient& first = patient(false);
  EXPECT_EQ(again.ct.hounsfield, first.ct.hounsfield);
  ASSERT_EQ(again.segmentation.structures.size(), first.segmentation.structures.size());
  for (std::size_t n = 0; n < first.segmentation.structures.size(); ++n) {
    const Mask& a = *again.segmentation.structures[n].mask;
    const Mask& b = *first.segmentation.structures[n].mask;
    EXPECT_EQ(a.box(), b.box());
    EXPECT_TRUE(std::equal(a.values().begin(), a.values().end(), b.values().begin(), b.values().end()));
  }
}

// The bytes are a contract between machines: this number changes only with the recipe.
TEST(SamplePatient, HasTheVoxelsItAlwaysHad) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const std::int16_t hu : patient(false).ct.hounsfield) {
    hash = (hash ^ static_cast<std::uint16_t>(hu)) * 0x100000001b3ULL;
  }
  EXPECT_EQ(hash, 8017242826086081610ULL);
}

TEST(SamplePatient, OneTumourLiesCloseToAVessel) {
  const sample::VesselTrees trees = sample::growVessels(1.5);
  double nearest = 1e9;
  for (const sample::VesselTree* tree : {&trees.portal, &trees.hepatic}) {
    for (const sample::Branch& branch : tree->branches) {
      for (const sample::Ellipsoid& tumour : sample::tumours()) {
        nearest = std::min(nearest, sample::signedDistance(tumour, branch.shape.to) - branch.shape.toRadius);
      }
    }
  }
  EXPECT_GT(nearest, 2);
  EXPECT_LT(nearest, 8);
}

TEST(SamplePatient, CancelEndsTheWork) {
  const ExecutionContext context;
  context.cancel();
  EXPECT_THROW(makeSamplePatient(false, context), Cancelled);
}

}  // namespace
}  // namespace glisson
