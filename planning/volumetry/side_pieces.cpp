#include "planning/volumetry/side_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "reconstruction/mesh/union_find.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
constexpr std::array kSides{PlanSide::Resected, PlanSide::Remnant};

std::size_t indexOf(PlanSide side) { return side == PlanSide::Resected ? 0 : 1; }
PlanSide other(PlanSide side) { return side == PlanSide::Resected ? PlanSide::Remnant : PlanSide::Resected; }

std::int64_t unitsOn(PlanSide side, const RunPart& part) {
  return side == PlanSide::Resected ? part.resected : part.units() - part.resected;
}

int endOf(const RunPart& part) { return part.run.i + part.run.n; }
}  // namespace

SidePieces::SidePieces(const VoxelRows& liver, const Vec3& spacing, const std::vector<ImageResection>& plan)
    : spacing_(spacing),
      parts_(partsOf(liver, spacing, plan)),
      rows_(parts_.size(), [this](std::size_t n) { return parts_[n].run; }) {
  connect();
  measure(plan.size());
}

void SidePieces::connect() {
  std::array<UnionFind, 2> groups{UnionFind(parts_.size()), UnionFind(parts_.size())};
  const auto unite = [&](std::size_t a, std::size_t b) {
    for (const PlanSide side : kSides) {
      if (unitsOn(side, parts_[a]) > 0 && unitsOn(side, parts_[b]) > 0) {
        groups[indexOf(side)].unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
      }
    }
  };
  rows_.forEachRow([&](int j, int k, const RowTable::Range& row) {
    for (std::size_t n = row.begin; n + 1 < row.end; ++n) {
      if (endOf(parts_[n]) == parts_[n + 1].run.i) {
        unite(n, n + 1);
      }
    }
    for (const RowTable::Range& next : {rows_.row(j + 1, k), rows_.row(j, k + 1)}) {
      std::size_t a = row.begin;
      std::size_t b = next.begin;
      while (a < row.end && b < next.end) {
        if (std::max(parts_[a].run.i, parts_[b].run.i) < std::min(endOf(parts_[a]), endOf(parts_[b]))) {
          unite(a, b);
        }
        ++(endOf(parts_[a]) < endOf(parts_[b]) ? a : b);
      }
    }
  });
  for (const PlanSide side : kSides) {
    std::vector<std::uint32_t>& piece = piece_[indexOf(side)];
    piece.assign(parts_.size(), kNone);
    for (std::uint32_t n = 0; n < parts_.size(); ++n) {
      if (unitsOn(side, parts_[n]) == 0) {
        continue;
      }
      const std::uint32_t first = groups[indexOf(side)].find(n);  // the piece's first part: none comes before it
      if (first == n) {
        piece[n] = static_cast<std::uint32_t>(pieces_.size());
        pieces_.push_back({side, 0, false, false, Vec3::Zero()});
      }
      piece[n] = piece[first];
    }
  }
}

void SidePieces::measure(std::size_t resections) {
  std::vector<int> longest(pieces_.size(), 0);
  // Of each piece, what each resection has of it; the last owner is the remnant.
  const std::size_t owners = resections + 1;
  std::vector<std::int64_t> owned(pieces_.size() * owners, 0);
  for (const PlanSide side : kSides) {
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      const std::uint32_t number = piece_[indexOf(side)][n];
      if (number == kNone) {
        continue;
      }
      SidePiece& piece = pieces_[number];
      piece.units += unitsOn(side, parts_[n]);
      owned[number * owners + (side == PlanSide::Resected ? parts_[n].owner : resections)] += unitsOn(side, parts_[n]);
      const RowRun& run = parts_[n].run;
      const int length = parts_[n].isDivided() ? 1 : run.n;
      if (length > longest[number]) {
        longest[number] = length;
        const int middle = run.i + (length - 1) / 2;  // a voxel's centre
        piece.point = spacing_.cwiseProduct(Vec3(middle, run.j, run.k));
      }
    }
  }
  for (std::size_t owner = 0; owner < owners; ++owner) {
    std::size_t largest = pieces_.size();
    std::int64_t most = 0;
    for (std::size_t n = 0; n < pieces_.size(); ++n) {
      if (owned[n * owners + owner] > most) {
        most = owned[n * owners + owner];
        largest = n;
      }
    }
    if (largest < pieces_.size()) {
      pieces_[largest].main = true;
    }
  }
}

std::optional<std::size_t> SidePieces::partAt(int i, int j, int k) const {
  const RowTable::Range row = rows_.row(j, k);
  const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(row.begin);
  const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(row.end);
  auto at = std::upper_bound(begin, end, i, [](int value, const RunPart& part) { return value < part.run.i; });
  if (at == begin || i >= endOf(*std::prev(at))) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(std::prev(at) - parts_.begin());
}

std::optional<std::size_t> SidePieces::pieceAt(PlanSide side, int i, int j, int k) const {
  const auto part = partAt(i, j, k);
  if (!part || piece_[indexOf(side)][*part] == kNone) {
    return std::nullopt;
  }
  return piece_[indexOf(side)][*part];
}

std::optional<std::size_t> SidePieces::pieceAt(PlanSide side, const Vec3& image) const {
  const Vec3 index = image.cwiseQuotient(spacing_);
  constexpr double kFarthest = 1e6;  // of any grid
  if (!(index.cwiseAbs().maxCoeff() < kFarthest)) {
    return std::nullopt;
  }
  return pieceAt(side, static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
                 static_cast<int>(std::lround(index[2])));
}

bool SidePieces::switchAt(const Vec3& image, PlanSide to) {
  const auto piece = pieceAt(other(to), image);
  if (!piece || pieces_[*piece].main) {
    return false;
  }
  pieces_[*piece].switched = true;
  return true;
}

bool SidePieces::anySwitched() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [](const SidePiece& p) { return p.switched; });
}

bool SidePieces::isSwitched(PlanSide side, const Index3& voxel) const {
  const auto piece = pieceAt(side, voxel[0], voxel[1], voxel[2]);
  return piece && pieces_[*piece].switched;
}

std::int64_t SidePieces::switchedUnits(const VoxelRows& rows, const std::vector<ImageResection>& plan,
                                       std::vector<std::int64_t>* perPiece) const {
  std::int64_t brought = 0;
  if (perPiece != nullptr) {
    perPiece->assign(pieces_.size(), 0);
  }
  const auto add = [&](PlanSide side, const RowRun& run, std::int64_t units) {
    const auto piece = pieceAt(side, run.i, run.j, run.k);
    if (units == 0 || !piece) {
      return;
    }
    if (perPiece != nullptr) {
      (*perPiece)[*piece] += units;
    }
    if (pieces_[*piece].switched) {
      brought += side == PlanSide::Remnant ? units : -units;
    }
  };
  for (const RunPart& part : partsOf(rows, spacing_, plan)) {
    // These voxels need not lie in L: each is looked up by itself where the part reaches over L's own.
    const auto own = partAt(part.run.i, part.run.j, part.run.k);
    if (own && endOf(part) <= endOf(parts_[*own])) {
      add(PlanSide::Resected, part.run, part.resected);
      add(PlanSide::Remnant, part.run, part.units() - part.resected);
      continue;
    }
    for (int i = part.run.i; i < endOf(part); ++i) {
      const RowRun voxel{i, part.run.j, part.run.k, 1};
      const std::int64_t units = std::int64_t{1} << 32;
      const std::int64_t resected =
          part.isDivided() ? resectedUnits(VoxelRows{{voxel}, 1}, spacing_, plan) : part.resected / part.run.n;
      add(PlanSide::Resected, voxel, resected);
      add(PlanSide::Remnant, voxel, units - resected);
    }
  }
  return brought;
}

bool SidePieces::separates(const CutPiece& cut) const {
  const Vec3 middle =
      std::accumulate(cut.polygon.begin(), cut.polygon.end(), Vec3(0, 0, 0)) / static_cast<double>(cut.polygon.size());
  const Vec3 step = 1e-3 * spacing_.minCoeff() * cut.normal;
  const auto switchedAt = [&](PlanSide side, const Vec3& p) {
    const auto piece = pieceAt(side, p);
    return piece && pieces_[*piece].switched;
  };
  const bool frontChanged = switchedAt(PlanSide::Resected, middle + step);
  const bool backChanged = switchedAt(PlanSide::Remnant, middle - step);
  return frontChanged == backChanged;
}

namespace {
std::string noIsland(const Vec3& point) {
  return "The piece at (" + formatNumber(point[0], 1) + ", " + formatNumber(point[1], 1) + ", " + formatNumber(point[2], 1) +
         ") mm is no island of its own, so it counts on the side where the planes leave it.";
}

}  // namespace

std::optional<SidePieces> switchedSides(const VoxelRows& liver, const ImageGeometry& geometry, const ResectionPlan& plan,
                                        const std::vector<ImageResection>& resections, std::string* warning) {
  if (plan.islands.empty()) {
    return std::nullopt;
  }
  SidePieces sides(liver, geometry.spacing, resections);
  for (const IslandAssignment& island : plan.islands) {
    const bool moved = sides.switchAt(geometry.direction.transpose() * (island.point - geometry.origin), island.to);
    if (!moved && warning != nullptr) {
      *warning += (warning->empty() ? "" : " ") + noIsland(island.point);
    }
  }
  return sides;
}

}  // namespace glisson
