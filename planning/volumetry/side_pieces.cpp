#include "planning/volumetry/side_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "reconstruction/mesh/union_find.h"

namespace glisson {

namespace {
constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);
constexpr std::array kSides{PlanSide::Resected, PlanSide::Remnant};

std::size_t indexOf(PlanSide side) { return side == PlanSide::Resected ? 0 : 1; }
PlanSide other(PlanSide side) { return side == PlanSide::Resected ? PlanSide::Remnant : PlanSide::Resected; }

std::int64_t unitsOn(PlanSide side, const RunPart& part) {
  return side == PlanSide::Resected ? part.resected : part.units() - part.resected;
}
}  // namespace

SidePieces::SidePieces(const VoxelRows& liver, const Vec3& spacing, const std::vector<ImageResection>& plan)
    : spacing_(spacing), parts_(partsOf(liver, spacing, plan)) {
  for (std::size_t n = 0; n < parts_.size(); ++n) {
    const auto [row, isNew] = rows_.try_emplace({parts_[n].run.k, parts_[n].run.j}, n, n);
    row->second.second = n + 1;
  }
  connect();
  measure(plan.size());
}

void SidePieces::connect() {
  for (const PlanSide side : kSides) {
    UnionFind groups(parts_.size());
    const auto has = [&](std::size_t n) { return unitsOn(side, parts_[n]) > 0; };
    for (const auto& [row, range] : rows_) {
      for (std::size_t n = range.first; n + 1 < range.second; ++n) {
        const bool touch = parts_[n].run.i + parts_[n].run.n == parts_[n + 1].run.i;
        if (touch && has(n) && has(n + 1)) {
          groups.unite(static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n + 1));
        }
      }
      for (const auto& next : {rows_.find({row.first, row.second + 1}), rows_.find({row.first + 1, row.second})}) {
        if (next == rows_.end()) {
          continue;
        }
        std::size_t b = next->second.first;
        for (std::size_t a = range.first; a < range.second; ++a) {
          const int end = parts_[a].run.i + parts_[a].run.n;
          while (b > next->second.first && parts_[b - 1].run.i + parts_[b - 1].run.n > parts_[a].run.i) {
            --b;
          }
          for (; b < next->second.second && parts_[b].run.i < end; ++b) {
            const bool overlap = parts_[b].run.i + parts_[b].run.n > parts_[a].run.i;
            if (overlap && has(a) && has(b)) {
              groups.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
            }
          }
        }
      }
    }
    std::vector<std::uint32_t>& piece = piece_[indexOf(side)];
    piece.assign(parts_.size(), kNone);
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (std::uint32_t n = 0; n < parts_.size(); ++n) {
      if (has(n)) {
        const auto [at, isNew] = numbers.try_emplace(groups.find(n), static_cast<std::uint32_t>(pieces_.size()));
        if (isNew) {
          pieces_.push_back({side, 0, false, false, Vec3::Zero()});
        }
        piece[n] = at->second;
      }
    }
  }
}

void SidePieces::measure(std::size_t resections) {
  std::vector<int> longest(pieces_.size(), 0);
  std::vector<std::map<std::size_t, std::int64_t>> owned(pieces_.size());
  for (const PlanSide side : kSides) {
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      const std::uint32_t number = piece_[indexOf(side)][n];
      if (number == kNone) {
        continue;
      }
      SidePiece& piece = pieces_[number];
      piece.units += unitsOn(side, parts_[n]);
      owned[number][side == PlanSide::Resected ? parts_[n].owner : resections] += unitsOn(side, parts_[n]);
      const RowRun& run = parts_[n].run;
      if (run.n > longest[number]) {
        longest[number] = run.n;
        const int middle = run.i + (run.n - 1) / 2;  // a voxel's centre
        piece.point = spacing_.cwiseProduct(Vec3(middle, run.j, run.k));
      }
    }
  }
  // The last owner is the remnant.
  for (std::size_t owner = 0; owner <= resections; ++owner) {
    std::size_t largest = pieces_.size();
    std::int64_t most = 0;
    for (std::size_t n = 0; n < pieces_.size(); ++n) {
      const auto found = owned[n].find(owner);
      if (found != owned[n].end() && found->second > most) {
        most = found->second;
        largest = n;
      }
    }
    if (largest < pieces_.size()) {
      pieces_[largest].main = true;
    }
  }
}

std::optional<std::size_t> SidePieces::partAt(int i, int j, int k) const {
  const auto row = rows_.find({k, j});
  if (row == rows_.end()) {
    return std::nullopt;
  }
  const auto begin = parts_.begin() + static_cast<std::ptrdiff_t>(row->second.first);
  const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(row->second.second);
  auto at = std::upper_bound(begin, end, i, [](int value, const RunPart& part) { return value < part.run.i; });
  if (at == begin || i >= std::prev(at)->run.i + std::prev(at)->run.n) {
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

bool SidePieces::anySwitched(PlanSide from) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const SidePiece& p) { return p.switched && p.side == from; });
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
    const bool within = own && part.run.i + part.run.n <= parts_[*own].run.i + parts_[*own].run.n;
    const int step = within ? part.run.n : 1;
    for (int i = part.run.i; i < part.run.i + part.run.n; i += step) {
      const RowRun run{i, part.run.j, part.run.k, step};
      const std::int64_t resected = part.run.n == step ? part.resected : part.resected / part.run.n;
      add(PlanSide::Resected, run, resected);
      add(PlanSide::Remnant, run, (static_cast<std::int64_t>(step) << 32) - resected);
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

}  // namespace glisson
