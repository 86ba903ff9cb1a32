#include "reconstruction/mesh/triangulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glisson::planar {

Triangulation::Triangulation(std::span<const Vec2> points) : points_(points.begin(), points.end()), count_(points.size()) {
  addSurroundingFace();
  for (const std::uint32_t point : insertionOrder()) {
    insert(point);
  }
}

void Triangulation::fix(std::uint32_t a, std::uint32_t b) {
  std::deque<std::array<std::uint32_t, 2>> crossing = sidesCrossing(a, b);
  std::vector<std::array<std::uint32_t, 2>> made;
  // Every pass over the crossing sides flips at least one of them.
  std::size_t patience = 4 * crossing.size() * crossing.size() + 16;
  while (!crossing.empty()) {
    if (patience-- == 0) {
      throw NoFill();
    }
    const auto [u, v] = crossing.front();
    crossing.pop_front();
    const SideOf side = findSide(u, v);
    if (!isStrictlyConvex(side)) {
      crossing.push_back({u, v});
      continue;
    }
    const auto flipped = flip(side);
    if (cross(a, b, flipped[0], flipped[1])) {
      crossing.push_back(flipped);
    } else {
      made.push_back(flipped);
    }
  }
  setFixed(findSide(a, b));
  for (const auto& [u, v] : made) {
    const auto side = sideBetween(u, v);  // none where legalising another one has flipped it since
    if (side) {
      legalise({*side});
    }
  }
}

void Triangulation::addSurroundingFace() {
  Vec2 low = points_.front();
  Vec2 high = low;
  for (const Vec2& p : points_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 centre = 0.5 * (low + high);
  const double reach = 64.0 * std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
  points_.emplace_back(centre[0] - reach, centre[1] - reach);
  points_.emplace_back(centre[0] + reach, centre[1] - reach);
  points_.emplace_back(centre[0], centre[1] + reach);
  const auto n = static_cast<std::uint32_t>(count_);
  faces_.push_back({{n, n + 1, n + 2}, {kNone, kNone, kNone}, {false, false, false}});
  faceAt_.assign(points_.size(), 0);
}

std::vector<std::uint32_t> Triangulation::insertionOrder() const {
  const Vec2 low(points_[count_][0], points_[count_][1]);
  const double width = points_[count_ + 1][0] - low[0];
  const double columns = std::max(1.0, std::sqrt(static_cast<double>(count_))) * 128.0;
  const auto column = [&](std::uint32_t n) { return static_cast<long>((points_[n][0] - low[0]) / width * columns); };
  std::vector<std::uint32_t> order(count_);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const long ca = column(a);
    const long cb = column(b);
    if (ca != cb) {
      return ca < cb;
    }
    if (points_[a][1] != points_[b][1]) {
      return ca % 2 == 0 ? points_[a][1] < points_[b][1] : points_[a][1] > points_[b][1];
    }
    return a < b;
  });
  return order;
}

int Triangulation::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return orientation(points_[a], points_[b], points_[c]);
}

std::uint32_t Triangulation::locate(std::uint32_t point) const {
  std::uint32_t face = static_cast<std::uint32_t>(faces_.size()) - 1;
  for (std::size_t steps = 0; steps <= 4 * faces_.size(); ++steps) {
    const Face& f = faces_[face];
    bool moved = false;
    for (std::size_t n = 0; n < 3 && !moved; ++n) {
      // Another first side each step, so that the walk does not circle.
      const std::size_t place = (n + steps) % 3;
      if (turn(f.corner[next(place)], f.corner[previous(place)], point) < 0) {
        face = f.beyond[place];
        moved = true;
      }
    }
    if (!moved) {
      return face;
    }
    if (face == kNone) {
      break;
    }
  }
  for (std::uint32_t n = 0; n < faces_.size(); ++n) {
    const Triangle& c = faces_[n].corner;
    if (turn(c[0], c[1], point) >= 0 && turn(c[1], c[2], point) >= 0 && turn(c[2], c[0], point) >= 0) {
      return n;
    }
  }
  throw NoFill();
}

void Triangulation::insert(std::uint32_t point) {
  const std::uint32_t face = locate(point);
  const Face f = faces_[face];
  for (std::size_t place = 0; place < 3; ++place) {
    if (points_[f.corner[place]] == points_[point]) {
      throw NoFill();
    }
  }
  for (std::size_t place = 0; place < 3; ++place) {
    if (turn(f.corner[next(place)], f.corner[previous(place)], point) == 0) {
      insertOnSide(point, {face, place});
      return;
    }
  }
  const auto a = face;
  const auto b = addFace();
  const auto c = addFace();
  setFace(a, {point, f.corner[1], f.corner[2]}, {f.beyond[0], b, c});
  setFace(b, {f.corner[0], point, f.corner[2]}, {a, f.beyond[1], c});
  setFace(c, {f.corner[0], f.corner[1], point}, {a, b, f.beyond[2]});
  repoint(f.beyond[1], face, b);
  repoint(f.beyond[2], face, c);
  legalise({{a, 0}, {b, 1}, {c, 2}});
}

void Triangulation::insertOnSide(std::uint32_t point, SideOf side) {
  const Face f = faces_[side.face];
  const std::uint32_t across = f.beyond[side.place];
  if (across == kNone) {
    throw NoFill();
  }
  const Face g = faces_[across];
  const std::uint32_t p = f.corner[side.place];
  const std::uint32_t u = f.corner[next(side.place)];
  const std::uint32_t v = f.corner[previous(side.place)];
  const std::size_t q = placeOpposite(g, side.face);
  const std::uint32_t fu = f.beyond[previous(side.place)];  // beyond p-u
  const std::uint32_t fv = f.beyond[next(side.place)];      // beyond v-p
  const std::uint32_t gu = g.beyond[next(q)];               // beyond u-q
  const std::uint32_t gv = g.beyond[previous(q)];           // beyond q-v
  const std::uint32_t a = side.face;
  const std::uint32_t b = addFace();
  const std::uint32_t c = across;
  const std::uint32_t d = addFace();
  setFace(a, {p, u, point}, {c, b, fu});
  setFace(b, {p, point, v}, {d, fv, a});
  setFace(c, {g.corner[q], point, u}, {a, gu, d});
  setFace(d, {g.corner[q], v, point}, {b, c, gv});
  repoint(fv, side.face, b);
  repoint(gv, across, d);
  legalise({{a, 2}, {b, 1}, {c, 1}, {d, 2}});
}

std::uint32_t Triangulation::addFace() {
  faces_.emplace_back();
  return static_cast<std::uint32_t>(faces_.size()) - 1;
}

void Triangulation::setFace(std::uint32_t face, const Triangle& corner, const std::array<std::uint32_t, 3>& beyond) {
  faces_[face] = {corner, beyond, {false, false, false}};
  for (const std::uint32_t point : corner) {
    faceAt_[point] = face;
  }
}

void Triangulation::repoint(std::uint32_t face, std::uint32_t from, std::uint32_t to) {
  if (face != kNone) {
    auto& beyond = faces_[face].beyond;
    *std::find(beyond.begin(), beyond.end(), from) = to;
  }
}

std::size_t Triangulation::placeOpposite(const Face& face, std::uint32_t neighbour) {
  return face.beyond[0] == neighbour ? 0 : (face.beyond[1] == neighbour ? 1 : 2);
}

SideOf Triangulation::findSide(std::uint32_t u, std::uint32_t v) const {
  const auto side = sideBetween(u, v);
  if (!side) {
    throw NoFill();
  }
  return *side;
}

std::optional<SideOf> Triangulation::sideBetween(std::uint32_t u, std::uint32_t v) const {
  if (isSurrounding(u)) {
    // Its faces make no full turn; the side is as well seen from the other end.
    return isSurrounding(v) ? std::nullopt : sideBetween(v, u);
  }
  std::optional<SideOf> found;
  forFacesAround(u, [&](std::uint32_t face) {
    const Face& f = faces_[face];
    const std::size_t place = f.placeOf(u);
    if (f.corner[next(place)] == v) {
      found = SideOf{face, previous(place)};
    }
    return !found;
  });
  return found;
}

template <typename Visit>
void Triangulation::forFacesAround(std::uint32_t point, Visit&& visit) const {
  std::uint32_t face = faceAt_[point];
  do {
    if (!visit(face)) {
      return;
    }
    face = faces_[face].beyond[next(faces_[face].placeOf(point))];
  } while (face != faceAt_[point]);
}

bool Triangulation::isStrictlyConvex(SideOf side) const {
  const Face& f = faces_[side.face];
  const Face& g = faces_[f.beyond[side.place]];
  const std::uint32_t p = f.corner[side.place];
  const std::uint32_t u = f.corner[next(side.place)];
  const std::uint32_t v = f.corner[previous(side.place)];
  const std::uint32_t q = g.corner[placeOpposite(g, side.face)];
  return turn(p, u, q) > 0 && turn(q, v, p) > 0;
}

std::array<std::uint32_t, 2> Triangulation::flip(SideOf side) {
  const std::uint32_t a = side.face;
  const Face f = faces_[a];
  const std::uint32_t b = f.beyond[side.place];
  const Face g = faces_[b];
  const std::size_t i = side.place;
  const std::size_t j = placeOpposite(g, a);
  const std::uint32_t p = f.corner[i];
  const std::uint32_t u = f.corner[next(i)];
  const std::uint32_t v = f.corner[previous(i)];
  const std::uint32_t q = g.corner[j];
  setFace(a, {p, u, q}, {g.beyond[next(j)], b, f.beyond[previous(i)]});
  faces_[a].fixed = {g.fixed[next(j)], false, f.fixed[previous(i)]};
  setFace(b, {q, v, p}, {f.beyond[next(i)], a, g.beyond[previous(j)]});
  faces_[b].fixed = {f.fixed[next(i)], false, g.fixed[previous(j)]};
  repoint(g.beyond[next(j)], b, a);
  repoint(f.beyond[next(i)], a, b);
  return {p, q};
}

void Triangulation::legalise(std::vector<SideOf> sides) {
  while (!sides.empty()) {
    const SideOf side = sides.back();
    sides.pop_back();
    const Face& f = faces_[side.face];
    const std::uint32_t across = f.beyond[side.place];
    if (across == kNone || f.fixed[side.place]) {
      continue;
    }
    const Face& g = faces_[across];
    const std::uint32_t q = g.corner[placeOpposite(g, side.face)];
    if (surelyInCircle(points_[f.corner[0]], points_[f.corner[1]], points_[f.corner[2]], points_[q]) && isStrictlyConvex(side)) {
      flip(side);
      sides.insert(sides.end(), {{side.face, 0}, {side.face, 2}, {across, 0}, {across, 2}});
    }
  }
}

void Triangulation::setFixed(SideOf side) {
  const std::uint32_t across = faces_[side.face].beyond[side.place];
  faces_[side.face].fixed[side.place] = true;
  faces_[across].fixed[placeOpposite(faces_[across], side.face)] = true;
}

bool Triangulation::cross(std::uint32_t a, std::uint32_t b, std::uint32_t u, std::uint32_t v) const {
  if (u == a || u == b || v == a || v == b) {
    return false;
  }
  return turn(a, b, u) * turn(a, b, v) < 0 && turn(u, v, a) * turn(u, v, b) < 0;
}

std::deque<std::array<std::uint32_t, 2>> Triangulation::sidesCrossing(std::uint32_t a, std::uint32_t b) const {
  std::deque<std::array<std::uint32_t, 2>> crossing;
  bool isSide = false;
  std::uint32_t face = kNone;
  forFacesAround(a, [&](std::uint32_t n) {
    const Face& f = faces_[n];
    const std::size_t place = f.placeOf(a);
    const std::uint32_t u = f.corner[next(place)];
    const std::uint32_t v = f.corner[previous(place)];
    isSide = u == b || v == b;
    if (!isSide && turn(a, b, u) < 0 && turn(a, b, v) > 0 && turn(u, v, b) < 0) {
      face = n;
    }
    return !isSide && face == kNone;
  });
  if (isSide) {
    return crossing;
  }
  if (face == kNone) {
    throw NoFill();  // a point lies on the segment
  }
  std::size_t place = faces_[face].placeOf(a);
  while (true) {
    const Face& f = faces_[face];
    if (f.fixed[place]) {
      throw NoFill();
    }
    crossing.push_back({f.corner[next(place)], f.corner[previous(place)]});
    const std::uint32_t across = f.beyond[place];
    const Face& g = faces_[across];
    const std::size_t apex = placeOpposite(g, face);
    if (g.corner[apex] == b) {
      return crossing;
    }
    const int side = turn(a, b, g.corner[apex]);
    if (side == 0) {
      throw NoFill();
    }
    // The apex left of a-b: the segment leaves across the side from the right end to the apex.
    place = side > 0 ? g.placeOf(f.corner[previous(place)]) : g.placeOf(f.corner[next(place)]);
    face = across;
  }
}

}  // namespace glisson::planar
