#include <algorithm>
#include <array>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/io/read.h"

namespace glisson {

namespace {
bool differ(const std::string& a, const std::string& b) { return !a.empty() && !b.empty() && a != b; }

/// A note where they differ and that was accepted.
void requireSamePatient(Segmentation& segmentation, const CtVolume& ct, const ReadOptions& options) {
  const bool otherId = differ(segmentation.patientId, ct.identity.patientId);
  const bool otherFrame = differ(segmentation.frameOfReferenceUid, ct.identity.frameOfReferenceUid);
  if (otherId || otherFrame) {  // which id, never its value: a message may be copied anywhere
    const std::string ids = otherId && otherFrame ? "PatientID and FrameOfReferenceUID"
                            : otherId             ? "PatientID"
                                                  : "FrameOfReferenceUID";
    if (options.consents.contains(Consent::OtherPatient)) {
      segmentation.notes.push_back("Labels of another " + std::string(otherId ? "patient" : "frame of reference") +
                                   " than the CT's were taken with consent (their " + ids + " differ).");
      return;
    }
    throw InputError(segmentation.source + " belongs to another " + (otherId ? "patient" : "frame of reference") + " than the CT " +
                     ct.source + " (their " + ids + " differ); choose the right files, or accept it with --accept other-patient.");
  }
}

/// Which axis of the labels runs along axis a of the CT, whether backwards, and at which of the CT's voxels it begins.
struct AxisMap {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::array<bool, 3> flipped{false, false, false};
  Index3 first{0, 0, 0};

  [[nodiscard]] ImageGeometry apply(const ImageGeometry& from) const {
    ImageGeometry to = from;
    Vec3 corner = Vec3::Zero();
    for (std::size_t a = 0; a < 3; ++a) {
      const auto column = static_cast<Eigen::Index>(a);
      const auto source = static_cast<Eigen::Index>(axis[a]);
      to.size[a] = from.size[axis[a]];
      to.spacing[column] = from.spacing[source];
      to.direction.col(column) = (flipped[a] ? -1.0 : 1.0) * from.direction.col(source);
      corner[source] = flipped[a] ? from.size[axis[a]] - 1 : 0;
    }
    to.origin = from.toWorld(corner);
    return to;
  }
};

/// The box of the CT's voxels that a grid is; nothing where it is none.
std::optional<IndexBox> partOf(const ImageGeometry& ct, const ImageGeometry& grid) {
  const Vec3 at = ct.toIndex(grid.origin).array().round();
  IndexBox box{.size = grid.size};
  for (std::size_t a = 0; a < 3; ++a) {
    const double first = at[static_cast<Eigen::Index>(a)];
    if (!(first >= 0 && first + grid.size[a] <= ct.size[a])) {
      return std::nullopt;
    }
    box.first[a] = static_cast<int>(first);
  }
  ImageGeometry part = ct;
  part.size = box.size;
  part.origin = ct.toWorld(at);
  return grid.cornerDistance(part) <= kSameGridMm ? std::optional(box) : std::nullopt;
}

/// The same voxels, or some of them (a crop), counted along other axes: found where a permutation and flips bring the corners
/// together.
std::optional<AxisMap> sameVoxels(const ImageGeometry& labels, const ImageGeometry& ct) {
  AxisMap map;
  do {
    for (unsigned flips = 0; flips < 8; ++flips) {
      for (std::size_t a = 0; a < 3; ++a) {
        map.flipped[a] = ((flips >> a) & 1U) != 0;
      }
      if (const std::optional<IndexBox> part = partOf(ct, map.apply(labels))) {
        map.first = part->first;
        return map;
      }
    }
  } while (std::ranges::next_permutation(map.axis).found);
  return std::nullopt;
}

Mask reordered(const Mask& mask, const AxisMap& map, const Index3& labelSize) {
  IndexBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t source = map.axis[a];
    box.size[a] = mask.box().size[source];
    box.first[a] = map.first[a] + (map.flipped[a] ? labelSize[source] - mask.box().first[source] - mask.box().size[source]
                                                  : mask.box().first[source]);
  }
  std::vector<std::uint8_t> values;
  values.reserve(box.voxelCount());
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i) {
        const Index3 voxel{box.first[0] + i, box.first[1] + j, box.first[2] + k};
        Index3 source{};
        for (std::size_t a = 0; a < 3; ++a) {
          const int at = voxel[a] - map.first[a];
          source[map.axis[a]] = map.flipped[a] ? labelSize[map.axis[a]] - 1 - at : at;
        }
        values.push_back(mask.at(source[0], source[1], source[2]) ? 1 : 0);
      }
    }
  }
  return {box, values};
}

/// The box of the CT that may hold a mask's box, one voxel wider.
IndexBox boxInCt(const IndexBox& box, const ImageGeometry& labels, const ImageGeometry& ct) {
  Vec3 low = Vec3::Constant(1e30);
  Vec3 high = Vec3::Constant(-1e30);
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (std::size_t a = 0; a < 3; ++a) {
      index[static_cast<Eigen::Index>(a)] = box.first[a] - 0.5 + (((corner >> a) & 1) != 0 ? box.size[a] : 0);
    }
    const Vec3 at = ct.toIndex(labels.toWorld(index));
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  IndexBox result;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double first = std::clamp(std::floor(low[axis]), 0.0, static_cast<double>(ct.size[a]));
    const double last = std::clamp(std::ceil(high[axis]), -1.0, ct.size[a] - 1.0);
    result.first[a] = static_cast<int>(first);
    result.size[a] = std::max(0, static_cast<int>(last - first) + 1);
  }
  return result;
}

/// Nearest neighbour: each CT voxel takes the label voxel its centre lies in.
Mask resampled(const Mask& mask, const ImageGeometry& labels, const ImageGeometry& ct) {
  if (mask.empty()) {
    return {};
  }
  const IndexBox box = boxInCt(mask.box(), labels, ct);
  if (box.voxelCount() == 0) {
    return {};
  }
  const Mat3 step = labels.spacing.cwiseInverse().asDiagonal() * labels.direction.transpose() * ct.indexToWorldMatrix();
  const Vec3 start = labels.toIndex(ct.origin);
  std::vector<std::uint8_t> values;
  values.reserve(box.voxelCount());
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      for (int i = 0; i < box.size[0]; ++i) {
        const Vec3 at = start + step * Vec3(box.first[0] + i, box.first[1] + j, box.first[2] + k);
        values.push_back(mask.at(static_cast<int>(std::floor(at[0] + 0.5)), static_cast<int>(std::floor(at[1] + 0.5)),
                                 static_cast<int>(std::floor(at[2] + 0.5)))
                             ? 1
                             : 0);
      }
    }
  }
  return {box, values};
}

/// A crop's border is not the image's: what is cut off there would not be seen any more.
void noteCrop(Segmentation& segmentation) {
  const Index3& size = segmentation.geometry.size;
  segmentation.notes.push_back("The labels lie on a part of the CT's grid (" + std::to_string(size[0]) + "x" +
                               std::to_string(size[1]) + "x" + std::to_string(size[2]) + " of its voxels).");
  for (const LabelledMask& structure : segmentation.structures) {
    if (structure.mask && structure.mask->touchesBorder(size)) {
      segmentation.notes.push_back("\"" + structure.name + "\" reaches the border of the labels' grid and may be cut off there.");
    }
  }
}
}  // namespace

Segmentation matchToCt(Segmentation segmentation, const CtVolume& ct, const ReadOptions& options) {
  requireSamePatient(segmentation, ct, options);
  if (segmentation.patientId.empty() || ct.identity.patientId.empty()) {
    segmentation.notes.emplace_back("Labels and CT do not both name their patient; they are matched by their geometry alone.");
  }
  const ImageGeometry labels = segmentation.geometry;
  if (labels.cornerDistance(ct.geometry) <= kSameGridMm) {
    return segmentation;
  }
  const std::optional<AxisMap> map = sameVoxels(labels, ct.geometry);
  if (!map && !options.consents.contains(Consent::ResampleLabels)) {
    throw InputError(segmentation.source + " does not lie on the grid of the CT (labels: " + labels.describe() + "; CT: " +
                     ct.geometry.describe() + "); choose the right files, or accept resampling with --accept resample-labels.");
  }
  if (map && labels.voxelCount() < ct.geometry.voxelCount()) {
    noteCrop(segmentation);
  }
  for (LabelledMask& structure : segmentation.structures) {
    if (!structure.mask) {
      continue;
    }
    const bool wasEmpty = structure.mask->empty();
    structure.mask = std::make_shared<const Mask>(map ? reordered(*structure.mask, *map, labels.size)
                                                      : resampled(*structure.mask, labels, ct.geometry));
    if (!wasEmpty && structure.mask->empty()) {
      segmentation.notes.push_back("\"" + structure.name + "\" has no voxel left on the CT's grid.");
    }
  }
  segmentation.geometry = ct.geometry;
  if (!map) {
    segmentation.notes.push_back("Labels were resampled (nearest) with consent from " + labels.describe() +
                                 " to the CT's grid of " + ct.geometry.describe() + ".");
  }
  return segmentation;
}

}  // namespace glisson
