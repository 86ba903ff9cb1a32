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
      : columns_(static_cast<int>(std::ceil(geometry.columns() * geometry.columnSpacing() / stepMm))),
        rows_(static_cast<int>(std::ceil(geometry.rows() * geometry.rowSpacing() / stepMm))),
        step_(static_cast<double>(geometry.columns()) / columns_, static_cast<double>(geometry.rows()) / rows_) {
    const BentSurface surface(plane);
    above_.reserve(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1));
    for (int row = 0; row <= rows_; ++row) {
      for (int column = 0; column <= columns_; ++column) {
        above_.push_back(surface.above(geometry.toWorld(nodeAt(column, row), slice)));
      }
    }
  }

  std::vector<std::vector<SlicePoint>> curves() {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        addTriangles(column, row);
      }
    }
    return joined();
  }

 private:
  [[nodiscard]] SlicePoint nodeAt(double column, double row) const {
    return SlicePoint(column, row).cwiseProduct(step_) - SlicePoint::Constant(0.5);
  }
  [[nodiscard]] double at(const std::array<int, 2>& node) const {
    return above_[static_cast<std::size_t>(node[1]) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(node[0])];
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

  int columns_;
  int rows_;
  SlicePoint step_;
  std::vector<double> above_;
  std::map<Edge, Edge> next_;
};
}  // namespace

std::vector<std::vector<SlicePoint>> slicesCurves(const SliceGeometry& geometry, int slice, const ResectionPlane& plane,
                                                  double stepMm) {
  return CurveFinder(geometry, slice, plane, stepMm).curves();
}

}  // namespace glisson
