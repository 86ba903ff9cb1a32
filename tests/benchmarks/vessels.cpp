// Vessels by marching cubes with smoothing and decimation beside Poisson reconstruction whose cells follow the sample spacing, then
// simplification (method.md 2 and 3): a row per tree and method, as Markdown on stdout.
//   vessels [--depths] [SEGMENTATION STRUCTURE...]   the thin sample patient's trees, the same trees as capsules on thicker slices,
//                                                  and structures of a patient; --depths: every depth instead of the methods

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/reconstruct.h"
#include "reconstruction/sample/sample_patient.h"
#include "reconstruction/sample/vessel_tree.h"
#include "reconstruction/text.h"

namespace glisson {
namespace {

struct Tree {
  std::string name;
  Mask mask;
  ImageGeometry geometry;
};

/// A tree of tapering capsules as voxels whose centres lie inside.
Tree capsuleTree(const sample::VesselTree& tree, double sliceMm) {
  constexpr double kPixelMm = 0.7;
  Vec3 low = tree.branches.front().shape.from;
  Vec3 high = low;
  for (const sample::Branch& branch : tree.branches) {
    const Vec3 reach = Vec3::Constant(std::max(branch.shape.fromRadius, branch.shape.toRadius) + 2 * sliceMm);
    low = low.cwiseMin(branch.shape.from - reach).cwiseMin(branch.shape.to - reach);
    high = high.cwiseMax(branch.shape.from + reach).cwiseMax(branch.shape.to + reach);
  }
  ImageGeometry geometry;
  geometry.spacing = Vec3(kPixelMm, kPixelMm, sliceMm);
  geometry.origin = low;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    geometry.size[a] = 1 + static_cast<int>((high[axis] - low[axis]) / geometry.spacing[axis]);
  }
  std::vector<std::uint8_t> values(geometry.voxelCount(), 0);
  for (const sample::Branch& branch : tree.branches) {
    const Vec3 reach = Vec3::Constant(std::max(branch.shape.fromRadius, branch.shape.toRadius));
    const Vec3 first = geometry.toIndex(branch.shape.from.cwiseMin(branch.shape.to) - reach);
    const Vec3 last = geometry.toIndex(branch.shape.from.cwiseMax(branch.shape.to) + reach);
    for (int k = static_cast<int>(first[2]); k <= static_cast<int>(last[2]) + 1; ++k) {
      for (int j = static_cast<int>(first[1]); j <= static_cast<int>(last[1]) + 1; ++j) {
        for (int i = static_cast<int>(first[0]); i <= static_cast<int>(last[0]) + 1; ++i) {
          if (signedDistance(branch.shape, geometry.toWorld(Vec3(i, j, k))) < 0) {
            values[static_cast<std::size_t>(i) + static_cast<std::size_t>(geometry.size[0]) *
                                                     (static_cast<std::size_t>(j) + static_cast<std::size_t>(geometry.size[1]) *
                                                                                        static_cast<std::size_t>(k))] = 1;
          }
        }
      }
    }
  }
  return {"capsules, " + formatNumber(sliceMm, 1) + " mm slices", Mask::fromGrid(geometry.size, values), geometry};
}

std::vector<Tree> treesOf(const std::vector<std::string>& words) {
  std::vector<Tree> trees;
  if (words.size() > 1) {
    const Segmentation patient = readSegmentation(words[0]);
    for (const LabelledMask& one : patient.structures) {
      if (std::find(words.begin() + 1, words.end(), one.name) != words.end()) {
        trees.push_back({one.name, *one.mask, patient.geometry});
      }
    }
  }
  const SamplePatient thin = makeSamplePatient(true);
  for (const LabelledMask& one : thin.segmentation.structures) {
    if (one.kind && isVessel(*one.kind)) {
      trees.push_back({"thin sample patient, " + one.name, *one.mask, thin.segmentation.geometry});
    }
  }
  const sample::VesselTrees grown = sample::growVessels(1.0);
  for (const double sliceMm : {0.8, 2.5, 5.0}) {
    trees.push_back(capsuleTree(grown.portal, sliceMm));
  }
  return trees;
}

ReconstructionParameters mcsd(SmoothingFilter filter, int smoothing) {
  ReconstructionParameters parameters;
  parameters.method = Method::Mcsd;
  parameters.mcsd = {.smoothing = smoothing, .filter = filter, .decimation = 0.25};
  return parameters;
}

/// depth 0: from the sample spacing.
ReconstructionParameters psr(int depth, double pointWeight, std::optional<double> simplifyMm = {}) {
  ReconstructionParameters parameters;
  parameters.autoDepth = depth == 0;
  parameters.psr.depth = depth == 0 ? parameters.psr.depth : depth;
  parameters.psr.pointWeight = pointWeight;
  if (simplifyMm) {
    parameters.simplify = SimplifyTarget{.distanceMm = simplifyMm};
  }
  return parameters;
}

std::vector<ReconstructionParameters> methodsOf(const Tree& tree, bool depths) {
  constexpr double kScreening = 16.0;
  if (depths) {
    return {psr(7, 0), psr(7, kScreening), psr(8, 0), psr(8, kScreening), psr(9, 0), psr(9, kScreening)};
  }
  return {mcsd(SmoothingFilter::Sinc, 10), mcsd(SmoothingFilter::Laplacian, 22), psr(0, 0), psr(0, kScreening),
          psr(0, kScreening, std::round(200 * tree.geometry.spacing.minCoeff()) / 1000)};
}

void printRow(const Tree& tree, const ReconstructionParameters& parameters) {
  try {
    const Reconstruction made = reconstruct(tree.mask, tree.geometry, StructureKind::PortalVein, parameters);
    std::string notes;
    for (const auto& list : {made.defects.names(), made.notes}) {
      for (const std::string& note : list) {
        notes += (notes.empty() ? "" : "; ") + note;
      }
    }
    const std::string centreline = made.centrelineInside ? formatNumber(100 * *made.centrelineInside, 2) : "";
    std::printf("| %s | %s | %d | %s | %zu / %zu | %+.2f | %zu | %zu | %.2f | %s |\n", tree.name.c_str(),
                parameters.describe().c_str(), made.usedDepth, centreline.c_str(), made.meshComponents, made.maskComponents,
                100 * made.volumeDeviation(), made.mesh.triangles.size(), countSelfIntersections(made.mesh), made.seconds.total(),
                notes.c_str());
  } catch (const Error& error) {
    std::printf("| %s | %s | %s |\n", tree.name.c_str(), parameters.describe().c_str(), error.what());
  }
  (void)std::fflush(stdout);
}

void run(std::vector<std::string> words) {
  const bool depths = !words.empty() && words.front() == "--depths";
  if (depths) {
    words.erase(words.begin());
  }
  std::printf(
      "| tree | method | depth used | centreline inside (%%) | pieces / mask's | volume (%%) | triangles | crossings | seconds | "
      "notes |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Tree& tree : treesOf(words)) {
    for (const ReconstructionParameters& parameters : methodsOf(tree, depths)) {
      printRow(tree, parameters);
    }
  }
}

}  // namespace
}  // namespace glisson

int main(int count, char** words) {
  try {
    glisson::run({words + 1, words + count});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vessels: %s\n", error.what());
    return 3;
  }
}
