#include "viewer/slice_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace glisson {

namespace {
class CurveFinder {
 public:
  CurveFinder(const SliceGeometry& geometry, int slice, const ResectionPlane& plane, double stepMm)
      : geometry_(geometry),
        slice_(slice),
        surface_(plane),
        columns_(static_cast<int>(std::ceil(geometry.columns() * geometry.columnSpacing() / stepMm))),
        rows_(static_cast<int>(std::ceil(geometry.rows() * geometry.rowSpacing() / stepMm))),
        step_(static_cast<double>(geometry.columns()) / columns_, static_cast<double>(geometry.rows()) / rows_),
        above_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1)) {}

  std::vector<std::vector<SlicePoint>> curves() {
    for (int row = 0; row < rows_; row += kCellsAtOnce) {
      for (int column = 0; column < columns_; column += kCellsAtOnce) {
        addCells(column, row, std::min(column + kCellsAtOnce, columns_), std::min(row + kCellsAtOnce, rows_));
      }
    }
    return joined();
  }

 private:
  [[nodiscard]] SlicePoint nodeAt(double column, double row) const {
    return SlicePoint(column, row).cwiseProduct(step_) - SlicePoint::Constant(0.5);
  }
  [[nodiscard]] std::size_t placeOf(const std::array<int, 2>& node) const {
    return static_cast<std::size_t>(node[1]) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(node[0]);
  }
  [[nodiscard]] double at(const std::array<int, 2>& node) const { return above_[placeOf(node)]; }

  static constexpr int kCellsAtOnce = 16;

  /// The cells from one node to another, unless the surface is surely far from all of them.
  void addCells(int column, int row, int columnEnd, int rowEnd) {
    const Vec3 centre = geometry_.toWorld(nodeAt(0.5 * (column + columnEnd), 0.5 * (row + rowEnd)), slice_);
    const Vec3 side = geometry_.toWorld(nodeAt(columnEnd, 0.5 * (row + rowEnd)), slice_) - centre;
    const Vec3 below = geometry_.toWorld(nodeAt(0.5 * (column + columnEnd), rowEnd), slice_) - centre;
    if (std::abs(surface_.above(centre)) > surface_.reach(side.cwiseAbs() + below.cwiseAbs())) {
      return;
    }
    for (int r = row; r <= rowEnd; ++r) {
      for (int c = column; c <= columnEnd; ++c) {
        above_[placeOf({c, r})] = surface_.above(geometry_.toWorld(nodeAt(c, r), slice_));
      }
    }
    for (int r = row; r < rowEnd; ++r) {
      for (int c = column; c < columnEnd; ++c) {
        addTriangles(c, r);
      }
    }
  }

  /// Two triangles a cell: no cell is then ambiguous.
  void addTriangles(int column, int row) {
    const std::array<int, 2> a{column, row};
    const std::array<int, 2> b{column + 1, row};
    const std::array<int, 2> c{column + 1, row + 1};
    const std::array<int, 2> d{column, row + 1};
    addTriangle({a, b, c});
    addTriangle({a, c, d});
  }

  using Edge = std::array<std::array<int, 2>, 2>;
  void addTriangle(const std::array<std::array<int, 2>, 3>& corner) {
    // The corners run clockwise (y down): the curve begins where going round leaves the resected side.
    Edge from{};
    Edge to{};
    bool crossed = false;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& a = corner[n];
      const auto& b = corner[(n + 1) % 3];
      if ((at(a) >= 0) != (at(b) >= 0)) {
        crossed = true;
        (at(a) >= 0 ? from : to) = {std::min(a, b), std::max(a, b)};
      }
    }
    if (crossed) {
      next_[from] = to;
    }
  }

  [[nodiscard]] SlicePoint crossing(const Edge& edge) const {
    const double a = at(edge[0]);
    const double b = at(edge[1]);
    const double share = a / (a - b);
    const SlicePoint first = nodeAt(edge[0][0], edge[0][1]);
    return first + share * (nodeAt(edge[1][0], edge[1][1]) - first);
  }

  /// Each edge has one segment that begins there and one that ends there, at the picture's border one of them only.
  std::vector<std::vector<SlicePoint>> joined() {
    std::map<Edge, bool> isEnd;
    for (const auto& [from, to] : next_) {
      isEnd[to] = true;
    }
    std::vector<std::vector<SlicePoint>> lines;
    const auto follow = [&](Edge edge) {
      std::vector<SlicePoint>& line = lines.emplace_back();
      line.push_back(crossing(edge));
      for (auto found = next_.find(edge); found != next_.end(); found = next_.find(edge)) {
        edge = found->second;
        line.push_back(crossing(edge));
        next_.erase(found);
      }
    };
    std::vector<Edge> starts;
    for (const auto& [from, to] : next_) {
      if (!isEnd.contains(from)) {
        starts.push_back(from);
      }
    }
    for (const Edge& start : starts) {
      follow(start);
    }
    while (!next_.empty()) {
      follow(next_.begin()->first);
    }
    return lines;
  }

  const SliceGeometry& geometry_;
  int slice_;
  BentSurface surface_;
  int columns_;
  int rows_;
  SlicePoint step_;
  std::vector<double> above_;  ///< by node, where the surface may be near
  std::map<Edge, Edge> next_;
};
}  // namespace

std::vector<std::vector<SlicePoint>> slicesCurves(const SliceGeometry& geometry, int slice, const ResectionPlane& plane,
                                                  double stepMm) {
  return CurveFinder(geometry, slice, plane, stepMm).curves();
}

}  // namespace glisson
