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

Rows foreground(const Mask& mask) {
  const IndexBox& box = mask.box();
  Rows rows{box.size[1], box.size[2], {}, {}};
  rows.closeRow();
  for (int k = 0; k < rows.nk; ++k) {
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
Rows background(const Mask& mask) {
  const IndexBox& box = mask.box();
  Rows rows{box.size[1] + 2, box.size[2] + 2, {}, {}};
  rows.closeRow();
  for (int k = -1; k <= box.size[2]; ++k) {
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

Pieces joined(Rows rows, Neighbours neighbours) {
  UnionFind sets(rows.runs.size());
  const int reach = neighbours == Neighbours::TwentySix ? 1 : 0;
  for (int k = 0; k < rows.nk; ++k) {
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

/// Rows of a mask as bits, 64 voxels a word, with an empty row on every side.
class BitRows {
 public:
  explicit BitRows(const Mask& mask)
      : words_(static_cast<std::size_t>(mask.box().size[0]) / 64 + 1), nj_(mask.box().size[1]), nk_(mask.box().size[2]) {
    bits_.resize(words_ * static_cast<std::size_t>(nj_ + 2) * static_cast<std::size_t>(nk_ + 2), 0);
    for (int k = 0; k < nk_; ++k) {
      for (int j = 0; j < nj_; ++j) {
        std::uint64_t* out = bits_.data() + offset(j, k);
        forRuns(rowOf(mask, j, k), mask.box().size[0], [&](int begin, int end) {
          for (int i = begin; i < end; ++i) {
            out[i / 64] |= std::uint64_t{1} << static_cast<unsigned>(i % 64);
          }
        });
      }
    }
  }
  [[nodiscard]] int rowsJ() const { return nj_; }
  [[nodiscard]] int rowsK() const { return nk_; }
  /// The number of runs in the row that `combine` makes of (j-1,k-1), (j,k-1), (j-1,k), (j,k).
  template <typename Combine>
  [[nodiscard]] long long runs(int j, int k, Combine&& combine) const {
    const std::uint64_t* a = bits_.data() + offset(j - 1, k - 1);
    const std::uint64_t* b = bits_.data() + offset(j, k - 1);
    const std::uint64_t* c = bits_.data() + offset(j - 1, k);
    const std::uint64_t* d = bits_.data() + offset(j, k);
    long long starts = 0;
    std::uint64_t carry = 0;
    for (std::size_t n = 0; n < words_; ++n) {
      const std::uint64_t word = combine(a[n], b[n], c[n], d[n]);
      starts += std::popcount(word & ~((word << 1U) | carry));
      carry = word >> 63U;
    }
    return starts;
  }
  /// Blocks of 2 x 2 x 2 voxels whose only two set voxels (unset ones where `invert` is all ones) are opposite corners.
  [[nodiscard]] long long lonePairs(int j, int k, std::uint64_t invert) const {
    const std::array<std::size_t, 4> row{offset(j - 1, k - 1), offset(j, k - 1), offset(j - 1, k), offset(j, k)};
    long long pairs = 0;
    for (std::size_t n = 0; n < words_; ++n) {
      std::array<std::uint64_t, 4> now{};
      std::array<std::uint64_t, 4> before{};  // the voxel before along i
      std::uint64_t any = 0;
      for (std::size_t r = 0; r < 4; ++r) {
        const std::uint64_t carry = n > 0 ? bits_[row[r] + n - 1] >> 63U : 0;
        now[r] = bits_[row[r] + n] ^ invert;
        before[r] = ((bits_[row[r] + n] << 1U) | carry) ^ invert;
        any |= now[r] | before[r];
      }
      if (any == 0) {
        continue;
      }
      for (std::size_t r = 0; r < 4; ++r) {
        std::uint64_t others = before[3 - r] | now[r];
        for (std::size_t other = 0; other < 4; ++other) {
          others |= other == r || other == 3 - r ? 0 : now[other] | before[other];
        }
        pairs += std::popcount(before[r] & now[3 - r] & ~others);
      }
    }
    return pairs;
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
}  // namespace

Pieces piecesOf(const Mask& mask, Neighbours neighbours) { return joined(foreground(mask), neighbours); }

Pieces cavitiesOf(const Mask& mask, Neighbours neighbours) {
  if (mask.empty()) {
    return {};
  }
  const Pieces all = joined(background(mask), neighbours);
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

GLISSON_WIDE EulerNumbers eulerNumbers(const Mask& mask) {
  EulerNumbers euler;
  if (mask.empty()) {
    return euler;
  }
  // Cells along i cancel but for one a run: of the voxels (d), of what lies between two rows, and of what lies between four. A
  // closed cell between rows is there where any of them is set (26), an open one where all are (6).
  const BitRows rows(mask);
  using Word = std::uint64_t;
  for (int k = 0; k <= rows.rowsK(); ++k) {
    for (int j = 0; j <= rows.rowsJ(); ++j) {
      const long long own = rows.runs(j, k, [](Word, Word, Word, Word d) { return d; });
      euler.facesEdgesCorners += own - rows.runs(j, k, [](Word, Word, Word c, Word d) { return c | d; }) -
                                 rows.runs(j, k, [](Word, Word b, Word, Word d) { return b | d; }) +
                                 rows.runs(j, k, [](Word a, Word b, Word c, Word d) { return a | b | c | d; });
      euler.faces += own - rows.runs(j, k, [](Word, Word, Word c, Word d) { return c & d; }) -
                     rows.runs(j, k, [](Word, Word b, Word, Word d) { return b & d; }) +
                     rows.runs(j, k, [](Word a, Word b, Word c, Word d) { return a & b & c & d; });
      // Two voxels alone in a block of eight that touch in its middle are joined by 26 and not by 18 neighbours.
      euler.facesEdges += rows.lonePairs(j, k, 0);
      euler.facesAsCubes += rows.lonePairs(j, k, ~Word{0});
    }
  }
  euler.facesEdges += euler.facesEdgesCorners;
  euler.facesAsCubes += euler.faces;
  return euler;
}

}  // namespace glisson
