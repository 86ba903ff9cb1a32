#include "reconstruction/mesh/mask_pieces.h"

#include <bit>
#include <cstring>

#include "reconstruction/mesh/union_find.h"
#include "reconstruction/wide.h"

namespace glisson {

namespace {
/// Runs of a box of rows; first[row] is the first run of row j + nj * k.
struct Rows {
  int nj = 0;
  int nk = 0;
  std::vector<VoxelRun> runs;
  std::vector<std::uint32_t> first;

  void closeRow() { first.push_back(static_cast<std::uint32_t>(runs.size())); }
};

const std::uint8_t* rowOf(const Mask& mask, int j, int k) {
  const Index3& size = mask.box().size;
  return mask.values().data() + static_cast<std::size_t>(size[0]) *
                                    (static_cast<std::size_t>(j) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
}

/// Calls visit(begin, end) for the runs of set voxels of a row of n.
template <typename Visit>
void forRuns(const std::uint8_t* row, int n, Visit&& visit) {
  int at = 0;
  while (at < n) {
    const void* begin = std::memchr(row + at, 1, static_cast<std::size_t>(n - at));
    if (begin == nullptr) {
      return;
    }
    const auto from = static_cast<int>(static_cast<const std::uint8_t*>(begin) - row);
    const void* end = std::memchr(row + from, 0, static_cast<std::size_t>(n - from));
    at = end == nullptr ? n : static_cast<int>(static_cast<const std::uint8_t*>(end) - row);
    visit(from, at);
  }
}

Rows foreground(const Mask& mask, const ExecutionContext& context) {
  const IndexBox& box = mask.box();
  Rows rows{box.size[1], box.size[2], {}, {}};
  rows.closeRow();
  for (int k = 0; k < rows.nk; ++k) {
    context.throwIfCancelled();
    for (int j = 0; j < rows.nj; ++j) {
      forRuns(rowOf(mask, j, k), box.size[0], [&](int begin, int end) {
        rows.runs.push_back({box.first[0] + begin, box.first[0] + end, box.first[1] + j, box.first[2] + k, 0});
      });
      rows.closeRow();
    }
  }
  return rows;
}

/// Of the mask's box with a border of one voxel: the first run belongs to the outside.
Rows background(const Mask& mask, const ExecutionContext& context) {
  const IndexBox& box = mask.box();
  Rows rows{box.size[1] + 2, box.size[2] + 2, {}, {}};
  rows.closeRow();
  for (int k = -1; k <= box.size[2]; ++k) {
    context.throwIfCancelled();
    for (int j = -1; j <= box.size[1]; ++j) {
      int at = -1;
      const auto add = [&](int begin, int end) {
        if (begin < end) {
          rows.runs.push_back({box.first[0] + begin, box.first[0] + end, box.first[1] + j, box.first[2] + k, 0});
        }
      };
      if (j >= 0 && k >= 0 && j < box.size[1] && k < box.size[2]) {
        forRuns(rowOf(mask, j, k), box.size[0], [&](int begin, int end) {
          add(at, begin);
          at = end;
        });
      }
      add(at, box.size[0] + 1);
      rows.closeRow();
    }
  }
  return rows;
}

/// Joins the runs of two rows that overlap, or come within `reach` of it.
void joinRows(const Rows& rows, std::size_t a, std::size_t b, int reach, UnionFind& pieces) {
  std::uint32_t m = rows.first[a];
  std::uint32_t n = rows.first[b];
  while (m < rows.first[a + 1] && n < rows.first[b + 1]) {
    const VoxelRun& x = rows.runs[m];
    const VoxelRun& y = rows.runs[n];
    if (x.begin < y.end + reach && y.begin < x.end + reach) {
      pieces.unite(m, n);
    }
    if (x.end < y.end) {
      ++m;
    } else {
      ++n;
    }
  }
}

Pieces joined(Rows rows, Neighbours neighbours, const ExecutionContext& context) {
  UnionFind sets(rows.runs.size());
  const int reach = neighbours == Neighbours::TwentySix ? 1 : 0;
  for (int k = 0; k < rows.nk; ++k) {
    context.throwIfCancelled();
    for (int j = 0; j < rows.nj; ++j) {
      const auto join = [&](int dj, int dk) {
        if (j + dj >= 0 && j + dj < rows.nj && k + dk >= 0) {
          const auto row = [&](int aj, int ak) {
            return static_cast<std::size_t>(aj) + static_cast<std::size_t>(rows.nj) * static_cast<std::size_t>(ak);
          };
          joinRows(rows, row(j, k), row(j + dj, k + dk), reach, sets);
        }
      };
      join(-1, 0);
      join(0, -1);
      if (reach == 1) {
        join(-1, -1);
        join(1, -1);
      }
    }
  }
  std::uint32_t count = 0;
  const auto number = sets.numbered(count);
  Pieces pieces{std::move(rows.runs), std::vector<std::size_t>(count, 0)};
  for (std::size_t n = 0; n < pieces.runs.size(); ++n) {
    pieces.runs[n].piece = number[n];
    pieces.voxels[number[n]] += static_cast<std::size_t>(pieces.runs[n].length());
  }
  return pieces;
}

void setBits(std::uint64_t* words, int begin, int end) {
  for (int at = begin; at < end;) {
    const int next = std::min(end, (at / 64 + 1) * 64);
    words[at / 64] |= (~std::uint64_t{0} >> static_cast<unsigned>(64 - (next - at))) << static_cast<unsigned>(at % 64);
    at = next;
  }
}

/// Rows of a mask as bits, 64 voxels a word, with an empty row on every side.
class BitRows {
 public:
  explicit BitRows(const Mask& mask)
      : words_(static_cast<std::size_t>(mask.box().size[0]) / 64 + 1), nj_(mask.box().size[1]), nk_(mask.box().size[2]) {
    bits_.resize(words_ * static_cast<std::size_t>(nj_ + 2) * static_cast<std::size_t>(nk_ + 2), 0);
    for (int k = 0; k < nk_; ++k) {
      for (int j = 0; j < nj_; ++j) {
        std::uint64_t* out = bits_.data() + offset(j, k);
        forRuns(rowOf(mask, j, k), mask.box().size[0], [&](int begin, int end) { setBits(out, begin, end); });
      }
    }
  }
  [[nodiscard]] int rowsJ() const { return nj_; }
  [[nodiscard]] int rowsK() const { return nk_; }
  /// Calls visit(now, before) for every 64 places of the rows (j-1,k-1), (j,k-1), (j-1,k), (j,k): their voxels there, and those one
  /// place before along i. Left out where all of them are alike: nothing begins there.
  template <typename Visit>
  void forMixedWords(int j, int k, Visit&& visit) const {
    const std::array<const std::uint64_t*, 4> row{bits_.data() + offset(j - 1, k - 1), bits_.data() + offset(j, k - 1),
                                                  bits_.data() + offset(j - 1, k), bits_.data() + offset(j, k)};
    std::array<std::uint64_t, 4> carry{};
    for (std::size_t n = 0; n < words_; ++n) {
      std::array<std::uint64_t, 4> now{};
      std::array<std::uint64_t, 4> before{};
      std::uint64_t any = 0;
      std::uint64_t all = ~std::uint64_t{0};
      for (std::size_t r = 0; r < 4; ++r) {
        now[r] = row[r][n];
        before[r] = (now[r] << 1U) | carry[r];
        carry[r] = now[r] >> 63U;
        any |= now[r] | before[r];
        all &= now[r] & before[r];
      }
      if (any != 0 && ~all != 0) {
        visit(now, before);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t offset(int j, int k) const {
    return words_ * (static_cast<std::size_t>(j + 1) + static_cast<std::size_t>(nj_ + 2) * static_cast<std::size_t>(k + 1));
  }
  std::size_t words_;
  int nj_;
  int nk_;
  std::vector<std::uint64_t> bits_;
};

using Words = std::array<std::uint64_t, 4>;

/// Places whose block of 2 x 2 x 2 voxels has only two set, at opposite corners.
int lonePairs(const Words& now, const Words& before) {
  int pairs = 0;
  for (std::size_t r = 0; r < 4; ++r) {
    std::uint64_t others = before[3 - r] | now[r];
    for (std::size_t other = 0; other < 4; ++other) {
      others |= other == r || other == 3 - r ? 0 : now[other] | before[other];
    }
    pairs += std::popcount(before[r] & now[3 - r] & ~others);
  }
  return pairs;
}

Words inverted(const Words& words) { return {~words[0], ~words[1], ~words[2], ~words[3]}; }

/// Runs that begin at these places in a row, or in what is made of several.
int starts(std::uint64_t now, std::uint64_t before) { return std::popcount(now & ~before); }
}  // namespace

Pieces piecesOf(const Mask& mask, Neighbours neighbours, const ExecutionContext& context) {
  return joined(foreground(mask, context), neighbours, context);
}

Pieces cavitiesOf(const Mask& mask, Neighbours neighbours, const ExecutionContext& context) {
  if (mask.empty()) {
    return {};
  }
  const Pieces all = joined(background(mask, context), neighbours, context);
  const std::uint32_t outside = all.runs.front().piece;  // 0: pieces are numbered by first run
  Pieces cavities;
  cavities.voxels.assign(all.voxels.begin() + 1, all.voxels.end());
  for (VoxelRun run : all.runs) {
    if (run.piece != outside) {
      --run.piece;
      cavities.runs.push_back(run);
    }
  }
  return cavities;
}

GLISSON_WIDE EulerNumbers eulerNumbers(const Mask& mask, const ExecutionContext& context) {
  EulerNumbers euler;
  if (mask.empty()) {
    return euler;
  }
  // Cells along i cancel but for one a run: of the voxels (d), of what lies between two rows, and of what lies between four. A
  // closed cell between rows is there where any of them is set (26), an open one where all are (6).
  const BitRows rows(mask);
  for (int k = 0; k <= rows.rowsK(); ++k) {
    context.throwIfCancelled();
    for (int j = 0; j <= rows.rowsJ(); ++j) {
      rows.forMixedWords(j, k, [&](const Words& now, const Words& before) {
        const auto& [a, b, c, d] = now;
        const auto& [a1, b1, c1, d1] = before;
        const int own = starts(d, d1);
        euler.facesEdgesCorners += own - starts(c | d, c1 | d1) - starts(b | d, b1 | d1) + starts(a | b | c | d, a1 | b1 | c1 | d1);
        euler.faces += own - starts(c & d, c1 & d1) - starts(b & d, b1 & d1) + starts(a & b & c & d, a1 & b1 & c1 & d1);
        // Two voxels alone in a block of eight that touch in its middle are joined by 26 and not by 18 neighbours.
        euler.facesEdges += lonePairs(now, before);
        euler.facesAsCubes += lonePairs(inverted(now), inverted(before));
      });
    }
  }
  euler.facesEdges += euler.facesEdgesCorners;
  euler.facesAsCubes += euler.faces;
  return euler;
}

}  // namespace glisson
