#include "planning/volumetry/tumour_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "planning/infinity.h"
#include "planning/volumetry/box_corners.h"
#include "reconstruction/json.h"

namespace glisson {

namespace {

/// Runs by slice and row, for the shortest way to them.
class RowFinder {
 public:
  RowFinder(const VoxelRows& rows, const Vec3& spacing) : spacing_(spacing) {
    for (const RowRun& run : rows.runs) {
      slices_[run.k][run.j].push_back(run);
    }
  }

  /// The shortest way from the boxes of `rows`, mm; infinity where there are none.
  [[nodiscard]] double shortest(const VoxelRows& rows) const {
    double squared = kInfinity;
    for (const RowRun& run : rows.runs) {
      fromRun(run, squared);
    }
    return std::sqrt(squared);
  }

 private:
  /// The gap between the boxes of voxels a and b along an axis; neighbours touch.
  static double gap(int a, int b, double spacing) { return std::max(0, std::abs(a - b) - 1) * spacing; }

  /// Rows by falling nearness, both ways from the middle, as long as they can be nearer than the best.
  template <typename Map, typename Visit>
  static void outwards(const Map& map, int middle, const Visit& visit) {
    auto up = map.lower_bound(middle);
    auto down = std::make_reverse_iterator(up);
    while (up != map.end() && visit(*up)) {
      ++up;
    }
    while (down != map.rend() && visit(*down)) {
      ++down;
    }
  }

  void fromRun(const RowRun& run, double& squared) const {
    outwards(slices_, run.k, [&](const auto& slice) {
      const double gapK = gap(slice.first, run.k, spacing_[2]);
      if (gapK * gapK >= squared) {
        return false;
      }
      outwards(slice.second, run.j, [&](const auto& row) {
        const double gapJ = gap(row.first, run.j, spacing_[1]);
        const double across = gapK * gapK + gapJ * gapJ;
        if (across >= squared) {
          return false;
        }
        for (const RowRun& other : row.second) {
          const int apart = std::max({0, other.i - (run.i + run.n), run.i - (other.i + other.n)});
          squared = std::min(squared, across + std::pow(apart * spacing_[0], 2));
        }
        return true;
      });
      return true;
    });
  }

  Vec3 spacing_;
  std::map<int, std::map<int, std::vector<RowRun>>> slices_;
};

/// What lies around a mask, as far as it is connected with the far side of its box by faces: cavities are none of it. One voxel
/// beyond the box is the nearest of all that lies farther.
struct Surroundings {
  VoxelRows inImage;
  VoxelRows beyond;  ///< where the image ends, and the mask may go on
};

Surroundings surroundingsOf(const Mask& mask, const Index3& imageSize) {
  IndexBox box = mask.box();
  for (std::size_t a = 0; a < 3; ++a) {
    --box.first[a];
    box.size[a] += 2;
  }
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(box.size[0]),
                                          static_cast<std::size_t>(box.size[0]) * static_cast<std::size_t>(box.size[1])};
  const auto voxelAt = [&](std::size_t n) {
    return Index3{box.first[0] + static_cast<int>(n % stride[1]),
                  box.first[1] + static_cast<int>(n / stride[1] % static_cast<std::size_t>(box.size[1])),
                  box.first[2] + static_cast<int>(n / stride[2])};
  };
  std::vector<std::uint8_t> reached(box.voxelCount(), 0);
  std::vector<std::size_t> open{0};  // a corner, which no mask has
  reached[0] = 1;
  while (!open.empty()) {
    const std::size_t n = open.back();
    open.pop_back();
    const Index3 v = voxelAt(n);
    for (std::size_t a = 0; a < 3; ++a) {
      for (const int step : {-1, 1}) {
        Index3 next = v;
        next[a] += step;
        const bool within = next[a] >= box.first[a] && next[a] < box.first[a] + box.size[a];
        const std::size_t m = step < 0 ? n - stride[a] : n + stride[a];
        if (within && reached[m] == 0 && !mask.at(next[0], next[1], next[2])) {
          reached[m] = 1;
          open.push_back(m);
        }
      }
    }
  }
  Surroundings around;
  for (std::size_t n = 0; n < reached.size(); ++n) {
    if (reached[n] != 0) {
      const Index3 v = voxelAt(n);
      bool inImage = true;
      for (std::size_t a = 0; a < 3; ++a) {
        inImage = inImage && v[a] >= 0 && v[a] < imageSize[a];
      }
      append(inImage ? around.inImage : around.beyond, {v[0], v[1], v[2], 1});
    }
  }
  return around;
}

const Mask* lesionMaskOf(const Case& source, const Structure& structure) {
  const auto& masks = source.segmentation->structures;
  const auto index = static_cast<std::size_t>(structure.sourceIndex);
  const bool has = structure.sourceIndex >= 0 && index < masks.size() && masks[index].mask && !masks[index].mask->empty();
  return has ? masks[index].mask.get() : nullptr;
}

struct Vessel {
  const Structure* structure;
  RowFinder finder;
};
}  // namespace

std::vector<TumourMeasures> tumourMeasures(const Case& source, const ExecutionContext& context) {
  const ImageGeometry& geometry = source.liver->geometry;
  const Surroundings around = surroundingsOf(source.liver->liver, geometry.size);
  const RowFinder outside(around.inImage, geometry.spacing);
  const RowFinder beyond(around.beyond, geometry.spacing);
  std::vector<Vessel> vessels;
  for (const Structure& structure : source.model->structures) {
    if (const Mask* mask = lesionMaskOf(source, structure); mask != nullptr && isVessel(structure.kind)) {
      vessels.push_back({&structure, RowFinder(rowsOf(*mask), geometry.spacing)});
    }
  }
  std::vector<TumourMeasures> measures;
  for (const Structure& structure : source.model->structures) {
    const Mask* mask = lesionMaskOf(source, structure);
    if (mask == nullptr || !isLesion(structure.kind)) {
      continue;
    }
    context.throwIfCancelled();
    const VoxelRows rows = rowsOf(*mask);
    TumourMeasures measured;
    measured.id = structure.id;
    measured.name = structure.name;
    measured.volumeMl = volumeMl(*mask, geometry);
    const auto [from, to] = farthestCorners(rows, geometry.spacing);
    measured.longestDiameterMm = (to - from).norm();
    measured.diameterFrom = geometry.origin + geometry.direction * from;
    measured.diameterTo = geometry.origin + geometry.direction * to;
    const double toBorder = beyond.shortest(rows);
    const double toOutside = outside.shortest(rows);
    measured.capsuleMm = std::min(toBorder, toOutside);
    measured.capsuleBeyondImage = toBorder < toOutside;
    for (const Vessel& vessel : vessels) {
      const double mm = vessel.finder.shortest(rows);
      if (!measured.vesselMm || mm < *measured.vesselMm) {
        measured.vesselMm = mm;
        measured.nearestVessel = vessel.structure->name;
        measured.nearestVesselId = vessel.structure->id;
      }
    }
    measures.push_back(std::move(measured));
  }
  return measures;
}

std::string toJson(const std::vector<TumourMeasures>& measures) {
  Json json = Json::array();
  for (const TumourMeasures& m : measures) {
    json.push_back({{"id", m.id},
                    {"name", m.name},
                    {"volumeMl", m.volumeMl},
                    {"longestDiameterMm", m.longestDiameterMm},
                    {"diameterFromMm", vectorJson(m.diameterFrom)},
                    {"diameterToMm", vectorJson(m.diameterTo)},
                    {"capsuleMm", m.capsuleMm},
                    {"capsuleBeyondImage", m.capsuleBeyondImage},
                    {"nearestVessel", m.vesselMm ? Json(m.nearestVessel) : Json(nullptr)},
                    {"vesselMm", m.vesselMm ? Json(*m.vesselMm) : Json(nullptr)}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
