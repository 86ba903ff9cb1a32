#pragma once
// Purpose: a constrained Delaunay triangulation of points in the plane: points inserted one by one into a surrounding face, then
// segments fixed as sides. Private to planar_fill.cpp, which says what of it is inside.
// Source: S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations, 1993; exact orientation tests.

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "reconstruction/mesh/predicates.h"
#include "reconstruction/mesh/surface_mesh.h"

namespace glisson::planar {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Thrown where the points or segments cannot be triangulated; caught by fillRegion.
struct NoFill {};

inline std::size_t next(std::size_t n) { return n == 2 ? 0 : n + 1; }
inline std::size_t previous(std::size_t n) { return n == 0 ? 2 : n - 1; }

/// A face: its corners counter-clockwise; for each corner the face beyond the opposite side, and whether that side is fixed.
struct Face {
  Triangle corner{};
  std::array<std::uint32_t, 3> beyond{kNone, kNone, kNone};
  std::array<bool, 3> fixed{false, false, false};

  [[nodiscard]] std::size_t placeOf(std::uint32_t point) const { return corner[0] == point ? 0 : (corner[1] == point ? 1 : 2); }
  [[nodiscard]] bool has(std::uint32_t point) const { return corner[0] == point || corner[1] == point || corner[2] == point; }
};

/// A side of a face, named by the face and the corner opposite to it.
struct SideOf {
  std::uint32_t face;
  std::size_t place;
};

class Triangulation {
 public:
  explicit Triangulation(std::span<const Vec2> points);
  /// Makes a-b a side of faces that no later flip removes. Throws NoFill where a point lies on it or a fixed side crosses it.
  void fix(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] bool isSurrounding(std::uint32_t point) const { return point >= count_; }

 private:
  void addSurroundingFace();
  /// Along columns up and down, so that the walk to the next point is short.
  [[nodiscard]] std::vector<std::uint32_t> insertionOrder() const;
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] std::uint32_t locate(std::uint32_t point) const;
  void insert(std::uint32_t point);
  void insertOnSide(std::uint32_t point, SideOf side);
  std::uint32_t addFace();
  void setFace(std::uint32_t face, const Triangle& corner, const std::array<std::uint32_t, 3>& beyond);
  void repoint(std::uint32_t face, std::uint32_t from, std::uint32_t to);
  [[nodiscard]] static std::size_t placeOpposite(const Face& face, std::uint32_t neighbour);
  [[nodiscard]] SideOf findSide(std::uint32_t u, std::uint32_t v) const;
  /// The side between u and v, seen from one of its faces.
  [[nodiscard]] std::optional<SideOf> sideBetween(std::uint32_t u, std::uint32_t v) const;
  /// Calls visit(face) for the faces around a point (never one of the surrounding three) until it returns false.
  template <typename Visit>
  void forFacesAround(std::uint32_t point, Visit&& visit) const;
  [[nodiscard]] bool isStrictlyConvex(SideOf side) const;
  /// Replaces a side by the other diagonal of its two faces, p-q; returns it.
  std::array<std::uint32_t, 2> flip(SideOf side);
  /// Flips sides, and those around them, until none is surely not Delaunay. Every flip is certain, so this ends.
  void legalise(std::vector<SideOf> sides);
  void setFixed(SideOf side);
  /// Do the open segments a-b and u-v cross? Their ends count as apart.
  [[nodiscard]] bool cross(std::uint32_t a, std::uint32_t b, std::uint32_t u, std::uint32_t v) const;
  /// The sides a segment crosses on its way from a to b; empty where it is a side already.
  [[nodiscard]] std::deque<std::array<std::uint32_t, 2>> sidesCrossing(std::uint32_t a, std::uint32_t b) const;

  std::vector<Vec2> points_;
  std::size_t count_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> faceAt_;
};

}  // namespace glisson::planar
