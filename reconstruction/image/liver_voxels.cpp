#include "reconstruction/image/liver_voxels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr std::uint8_t kLiver = 1;     ///< in the liver mask as given
constexpr std::uint8_t kLesion = 2;    ///< in a tumour or cyst
constexpr std::uint8_t kTube = 4;      ///< in a vessel or bile duct
constexpr std::uint8_t kAttached = 8;  ///< in a piece of lesion that touches the liver mask
constexpr std::uint8_t kSeen = 16;
constexpr std::uint8_t kOneAxis = 32;  ///< the three bits above the flags count axes

bool isTube(StructureKind kind) { return isVessel(kind) || kind == StructureKind::BileDuct; }

/// Flags per voxel over one box that has a border of background, so that neighbours need no check of bounds.
class FlagGrid {
 public:
  explicit FlagGrid(const IndexBox& inner) {
    for (std::size_t a = 0; a < 3; ++a) {
      box_.first[a] = inner.first[a] - 1;
      box_.size[a] = inner.size[a] + 2;
    }
    stride_ = {1, box_.size[0], static_cast<std::ptrdiff_t>(box_.size[0]) * box_.size[1]};
    flags_.resize(box_.voxelCount());
  }

  /// Sets `flag` where the mask is; voxels outside the box are left out (they cannot touch or be enclosed by the liver).
  void mark(const Mask& mask, std::uint8_t flag) {
    forEachVoxel(mask, [&](std::size_t at) { flags_[at] |= flag; });
  }

  /// visit(offset) for every set voxel of the mask that lies in the inner box, in scan order.
  template <typename Visit>
  void forEachVoxel(const Mask& mask, Visit&& visit) const {
    const IndexBox& b = mask.box();
    const auto values = mask.values();
    for (int k = 0; k < b.size[2]; ++k) {
      for (int j = 0; j < b.size[1]; ++j) {
        const int y = b.first[1] + j - box_.first[1];
        const int z = b.first[2] + k - box_.first[2];
        if (y < 1 || z < 1 || y > box_.size[1] - 2 || z > box_.size[2] - 2) {
          continue;
        }
        const int shift = b.first[0] - box_.first[0];
        const int from = std::max(0, 1 - shift);
        const int to = std::min(b.size[0], box_.size[0] - 1 - shift);
        const std::size_t source = static_cast<std::size_t>(b.size[0]) * (j + static_cast<std::size_t>(b.size[1]) * k);
        const std::size_t row = static_cast<std::size_t>(shift + stride_[1] * y + stride_[2] * z);
        for (int i = from; i < to; ++i) {
          if (values[source + i] != 0) {
            visit(row + i);
          }
        }
      }
    }
  }

  template <typename Rule>
  [[nodiscard]] Mask select(Rule&& rule) const {
    std::vector<std::uint8_t> chosen(flags_.size());
    std::transform(flags_.begin(), flags_.end(), chosen.begin(),
                   [&](std::uint8_t f) { return static_cast<std::uint8_t>(rule(f)); });
    return {box_, chosen};
  }

  [[nodiscard]] std::uint8_t& operator[](std::size_t at) { return flags_[at]; }
  [[nodiscard]] std::ptrdiff_t stride(std::size_t axis) const { return stride_[axis]; }

 private:
  IndexBox box_;
  std::array<std::ptrdiff_t, 3> stride_{};
  std::vector<std::uint8_t> flags_;
};

std::vector<const LabelledMask*> structuresThat(const Segmentation& segmentation, bool (*rule)(StructureKind)) {
  std::vector<const LabelledMask*> found;
  for (const LabelledMask& structure : segmentation.structures) {
    if (structure.kind && structure.mask && !structure.mask->empty() && rule(*structure.kind)) {
      found.push_back(&structure);
    }
  }
  return found;
}

/// The union in one pass, however many structures there are.
Mask unionOfAll(const std::vector<const LabelledMask*>& structures) {
  IndexBox box;
  for (const LabelledMask* structure : structures) {
    box = enclosing(box, structure->mask->box());
  }
  if (structures.size() == 1 || box.voxelCount() == 0) {
    return structures.empty() ? Mask() : *structures.front()->mask;
  }
  FlagGrid grid(box);
  for (const LabelledMask* structure : structures) {
    grid.mark(*structure->mask, 1);
  }
  return grid.select([](std::uint8_t f) { return f != 0; });
}

/// Voxels in both masks.
std::size_t sharedVoxels(const Mask& a, const Mask& b) {
  IndexBox both;
  for (std::size_t n = 0; n < 3; ++n) {
    both.first[n] = std::max(a.box().first[n], b.box().first[n]);
    both.size[n] = std::min(a.box().first[n] + a.box().size[n], b.box().first[n] + b.box().size[n]) - both.first[n];
    if (both.size[n] <= 0) {
      return 0;
    }
  }
  std::size_t count = 0;
  for (int k = both.first[2]; k < both.first[2] + both.size[2]; ++k) {
    for (int j = both.first[1]; j < both.first[1] + both.size[1]; ++j) {
      for (int i = both.first[0]; i < both.first[0] + both.size[0]; ++i) {
        count += a.at(i, j, k) && b.at(i, j, k) ? 1 : 0;
      }
    }
  }
  return count;
}

/// Marks with kAttached every 26-connected piece of lesions that overlaps the liver mask or touches it by a face, edge or corner.
void attachLesions(FlagGrid& grid, const Mask& lesions) {
  std::vector<std::size_t> piece;
  grid.forEachVoxel(lesions, [&](std::size_t seed) {
    if ((grid[seed] & kSeen) != 0) {
      return;
    }
    bool touches = false;
    piece.assign(1, seed);
    grid[seed] |= kSeen;
    for (std::size_t n = 0; n < piece.size(); ++n) {
      const std::size_t at = piece[n];
      touches = touches || (grid[at] & kLiver) != 0;
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const std::ptrdiff_t step =
            (neighbour % 3 - 1) + grid.stride(1) * (neighbour / 3 % 3 - 1) + grid.stride(2) * (neighbour / 9 - 1);
        std::uint8_t& flags = grid[at + step];
        touches = touches || (flags & kLiver) != 0;
        if ((flags & (kLesion | kSeen)) == kLesion) {
          flags |= kSeen;
          piece.push_back(at + step);
        }
      }
    }
    for (const std::size_t at : piece) {
      grid[at] |= touches ? kAttached : 0;
    }
  });
}

/// Counts per tube voxel, in units of kOneAxis, along how many image axes it is enclosed: the straight way through tube voxels ends
/// in liver on both sides. Liver here is the liver mask without tubes, and attached lesions: what a nested and an exclusive patient
/// have in common.
void countEnclosedAxes(FlagGrid& grid, const std::vector<std::size_t>& tubes) {
  const auto isSolid = [](std::uint8_t f) { return (f & kAttached) != 0 || (f & (kLiver | kTube)) == kLiver; };
  const auto isWay = [](std::uint8_t f) { return (f & (kTube | kAttached)) == kTube; };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::ptrdiff_t step = grid.stride(axis);
    for (const std::size_t start : tubes) {
      if (!isWay(grid[start]) || isWay(grid[start - step]) || !isSolid(grid[start - step])) {
        continue;
      }
      std::size_t end = start;
      while (isWay(grid[end])) {
        end += step;
      }
      if (isSolid(grid[end])) {
        for (std::size_t at = start; at != end; at += step) {
          grid[at] += kOneAxis;
        }
      }
    }
  }
}

class Notes {
 public:
  Notes(const ImageGeometry& geometry, std::vector<std::string>& notes)
      : voxelMl_(geometry.voxelVolumeMm3() * kMlPerMm3), notes_(notes) {}
  /// The sentence is kept where there are such voxels.
  void add(std::size_t voxels, const std::string& sentence) {
    if (voxels > 0) {
      notes_.push_back(sentence);
    }
  }
  [[nodiscard]] std::string ml(std::size_t voxels) const { return formatNumber(static_cast<double>(voxels) * voxelMl_, 3); }

 private:
  double voxelMl_;
  std::vector<std::string>& notes_;
};

void noteLesions(FlagGrid& grid, const std::vector<const LabelledMask*>& lesions, const std::vector<const LabelledMask*>& tubes,
                 Notes& notes) {
  for (const LabelledMask* lesion : lesions) {
    std::size_t outside = 0;
    std::size_t attached = 0;
    std::size_t inVessels = 0;
    grid.forEachVoxel(*lesion->mask, [&](std::size_t at) {
      attached += (grid[at] & kAttached) != 0 ? 1 : 0;
      outside += (grid[at] & (kAttached | kLiver)) == kAttached ? 1 : 0;
      inVessels += (grid[at] & kTube) != 0 ? 1 : 0;
    });
    const std::size_t apart = lesion->mask->count() - attached;
    inVessels = tubes.empty() ? 0 : inVessels;
    notes.add(outside, lesion->name + ": " + notes.ml(outside) + " mL lie outside the liver mask and are counted as liver.");
    notes.add(apart, lesion->name + ": " + notes.ml(apart) + " mL do not touch the liver and are not counted in it.");
    notes.add(inVessels, lesion->name + " and the vessels overlap by " + notes.ml(inVessels) + " mL; counted as lesion.");
  }
  for (std::size_t a = 0; a < lesions.size(); ++a) {
    for (std::size_t b = a + 1; b < lesions.size(); ++b) {
      const std::size_t shared = sharedVoxels(*lesions[a]->mask, *lesions[b]->mask);
      notes.add(shared, lesions[a]->name + " and " + lesions[b]->name + " overlap by " + notes.ml(shared) + " mL; counted once.");
    }
  }
}
}  // namespace

LiverVoxels liverVoxels(const Segmentation& segmentation) {
  const auto livers = structuresThat(segmentation, [](StructureKind kind) { return kind == StructureKind::Liver; });
  const auto lesions = structuresThat(segmentation, isLesion);
  const auto tubes = structuresThat(segmentation, isTube);
  if (livers.empty()) {
    throw ReconstructionError(segmentation.source + " holds no liver, or an empty one; choose a segmentation with a liver label.");
  }
  LiverVoxels result;
  result.geometry = segmentation.geometry;
  const Mask liver = unionOfAll(livers);
  result.tumour = unionOfAll(lesions);

  FlagGrid grid(enclosing(liver.box(), result.tumour.box()));
  grid.mark(liver, kLiver);
  grid.mark(result.tumour, kLesion);
  for (const LabelledMask* tube : tubes) {
    grid.mark(*tube->mask, kTube);
  }
  attachLesions(grid, result.tumour);

  std::vector<std::size_t> tubeVoxels;
  for (const LabelledMask* tube : tubes) {
    grid.forEachVoxel(*tube->mask, [&](std::size_t at) { tubeVoxels.push_back(at); });
  }
  std::sort(tubeVoxels.begin(), tubeVoxels.end());
  tubeVoxels.erase(std::unique(tubeVoxels.begin(), tubeVoxels.end()), tubeVoxels.end());
  countEnclosedAxes(grid, tubeVoxels);
  Notes notes(result.geometry, result.notes);
  noteLesions(grid, lesions, tubes, notes);
  std::size_t added = 0;
  std::size_t dropped = 0;
  for (const std::size_t at : tubeVoxels) {
    std::uint8_t& flags = grid[at];
    if ((flags & kAttached) != 0) {
      continue;
    }
    const bool was = (flags & kLiver) != 0;
    const bool enclosed = flags >= 2 * kOneAxis;
    added += !was && enclosed ? 1 : 0;
    dropped += was && !enclosed ? 1 : 0;
    flags = static_cast<std::uint8_t>(enclosed ? flags | kLiver : flags & ~kLiver);
  }
  notes.add(added, "Vessels: " + notes.ml(added) + " mL enclosed by the liver but outside its mask are counted as liver.");
  notes.add(dropped, "Vessels: " + notes.ml(dropped) +
                         " mL of the liver mask are vessel not enclosed by liver, where trunks leave it, and are not counted.");

  result.liver = grid.select([](std::uint8_t f) { return (f & (kLiver | kAttached)) != 0; });
  result.functional = grid.select([](std::uint8_t f) { return (f & kLiver) != 0 && (f & kLesion) == 0; });
  return result;
}

double volumeMl(const Mask& mask, const ImageGeometry& geometry) {
  return static_cast<double>(mask.count()) * geometry.voxelVolumeMm3() * kMlPerMm3;
}

double LiverVoxels::totalMl() const { return volumeMl(liver, geometry); }
double LiverVoxels::tumourMl() const { return volumeMl(tumour, geometry); }
double LiverVoxels::functionalMl() const { return volumeMl(functional, geometry); }

}  // namespace glisson
