#include "reconstruction/mesh/collapser.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "reconstruction/mesh/edges.h"
#include "reconstruction/mesh/untangle.h"
#include "reconstruction/parallel.h"

namespace glisson {

Collapser::Collapser(const SurfaceMesh& mesh, const ExecutionContext& context, std::vector<double> edgesMm)
    : connectivity_(mesh.vertices.size(), mesh.triangles, context),
      position_(mesh.vertices),
      quadric_(mesh.vertices.size()),
      wanted_(std::move(edgesMm)),
      cost_(3 * mesh.triangles.size(), kNever),
      old_(3 * mesh.triangles.size(), 1) {
  const Bounds bounds = boundsOf(mesh);
  centre_ = 0.5 * (bounds.low + bounds.high);
  for (std::size_t v = 0; v < position_.size(); ++v) {
    position_[v] -= centre_;
  }
  context.throwIfCancelled();
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = (position_[t[1]] - position_[t[0]]).cross(position_[t[2]] - position_[t[0]]);
    const double length = normal.norm();
    if (length > 0) {
      const Quadric plane = Quadric::ofPlane(normal / length, position_[t[0]], 0.5 * length);
      for (const std::uint32_t v : t) {
        quadric_[v] += plane;
      }
    }
  }
}

/// The place of least error among those that keep the volume. With y measured from the origin v0 of h: minimise the quadric plus a
/// slight pull to the edge's middle (it decides where the surface is flat), subject to g.y = r, where g sums the cross products of
/// the ring's outer edges: six times the volume of the triangles that stay is g.y, that of the ring before is r.
Collapser::Collapse Collapser::best(std::uint32_t h) const {
  constexpr double kPull = 1e-5;
  const std::uint32_t o = connectivity_.twin(h);
  const Vec3& origin = position_[connectivity_.origin(h)];
  const Vec3 edge = position_[connectivity_.origin(o)] - origin;
  Vec3 g = Vec3::Zero();
  double r = 0;
  connectivity_.forEachOutgoing(connectivity_.origin(h), [&](std::uint32_t out) {
    if (out != h && connectivity_.previous(out) != o) {
      g += (position_[connectivity_.target(out)] - origin).cross(position_[connectivity_.apex(out)] - origin);
    }
  });
  connectivity_.forEachOutgoing(connectivity_.origin(o), [&](std::uint32_t out) {
    if (out != o && connectivity_.previous(out) != h) {
      const Vec3 outer = (position_[connectivity_.target(out)] - origin).cross(position_[connectivity_.apex(out)] - origin);
      g += outer;
      r += edge.dot(outer);
    }
  });
  Quadric q = quadric_[connectivity_.origin(h)];
  q += quadric_[connectivity_.origin(o)];
  const Vec3 gradient = q.a * origin + q.b;
  const double atOrigin = q.at(origin);
  const double pull = kPull * q.a.trace() + 1e-12;
  const Mat3 a = q.a + pull * Mat3::Identity();
  const Vec3 middle = 0.5 * edge;
  const Eigen::LLT<Mat3> factor(a);
  Vec3 y = factor.solve(pull * middle - gradient);
  const Vec3 z = factor.solve(g);
  const double along = g.dot(z);
  if (along > 0) {
    y += z * ((r - g.dot(y)) / along);
  }
  const double reach = 4 * edge.squaredNorm();
  if (!((y - middle).squaredNorm() <= reach)) {
    y = g.squaredNorm() > 0 ? Vec3(middle + g * ((r - g.dot(middle)) / g.squaredNorm())) : middle;
    if (!((y - middle).squaredNorm() <= reach)) {
      return {origin, std::numeric_limits<double>::infinity(), g};
    }
  }
  const double cost = y.dot(q.a * y) + 2 * gradient.dot(y) + atOrigin + pull * (y - middle).squaredNorm();
  return {origin + y, std::max(cost, 0.0), g};
}

/// No triangle that stays turns by more than some 78 degrees or becomes a needle. What was a needle before has no side to keep: it
/// must face outward as the ring does.
bool Collapser::keepsSides(std::uint32_t h, const Collapse& collapse) const {
  constexpr double kLeastCosine = 0.0;
  constexpr double kNeedle = 0.001;  // height over the longest side
  const std::uint32_t o = connectivity_.twin(h);
  const Vec3& place = collapse.place;
  bool keeps = true;
  const auto look = [&](std::uint32_t out, std::uint32_t beside) {
    if (!keeps || out == h || out == o || connectivity_.previous(out) == beside) {
      return;
    }
    const Vec3& here = position_[connectivity_.origin(out)];
    const Vec3& b = position_[connectivity_.target(out)];
    const Vec3& c = position_[connectivity_.apex(out)];
    const auto shape = [&](const Vec3& corner, const Vec3& normal) {
      return normal.norm() / std::max({(b - corner).squaredNorm(), (c - corner).squaredNorm(), (b - c).squaredNorm()});
    };
    const Vec3 before = (b - here).cross(c - here);
    const Vec3 after = (b - place).cross(c - place);
    const double shapeBefore = shape(here, before);
    const double shapeAfter = shape(place, after);
    const Vec3& side = shapeBefore > kNeedle ? before : collapse.ring;
    keeps = after.dot(side) > kLeastCosine * after.norm() * side.norm() && shapeAfter > std::min(kNeedle, shapeBefore);
  };
  connectivity_.forEachOutgoing(connectivity_.origin(h), [&](std::uint32_t out) { look(out, o); });
  connectivity_.forEachOutgoing(connectivity_.origin(o), [&](std::uint32_t out) { look(out, h); });
  return keeps;
}

/// At the place that an edge is collapsed to: between what its ends want.
double Collapser::wantedEdge(std::uint32_t h, const Vec3& place) const {
  const std::uint32_t a = connectivity_.origin(h);
  const std::uint32_t b = connectivity_.target(h);
  const Vec3 edge = position_[b] - position_[a];
  const double along = edge.squaredNorm() > 0 ? std::clamp((place - position_[a]).dot(edge) / edge.squaredNorm(), 0.0, 1.0) : 0.5;
  return (1 - along) * wanted_[a] + along * wanted_[b];
}

bool Collapser::keepsEdgesShort(std::uint32_t h, const Vec3& place) const {
  constexpr double kLongest = 1.4;
  const double most = kLongest * wantedEdge(h, place);
  bool keeps = true;
  for (const std::uint32_t from : {h, connectivity_.twin(h)}) {
    connectivity_.forEachOutgoing(connectivity_.origin(from), [&](std::uint32_t out) {
      keeps = keeps && (out == h || out == connectivity_.twin(h) ||
                        (position_[connectivity_.target(out)] - place).squaredNorm() <= most * most);
    });
  }
  return keeps;
}

float Collapser::costOf(std::uint32_t h, const Collapse& collapse, double rmsMm) const {
  const std::uint32_t a = connectivity_.origin(h);
  const std::uint32_t b = connectivity_.target(h);
  if (!(collapse.error <= rmsMm * rmsMm * (quadric_[a].area + quadric_[b].area))) {
    return kNever;
  }
  if (wanted_.empty()) {
    return static_cast<float>(collapse.error);
  }
  const double length = (position_[b] - position_[a]).norm() / wantedEdge(h, collapse.place);
  return length < 1 && keepsEdgesShort(h, collapse.place) ? static_cast<float>(length) : kNever;
}

/// The costs of edges whose surroundings changed since the last pass.
void Collapser::findCosts(double rmsMm, const ExecutionContext& context) {
  constexpr std::size_t kGrain = 3072;
  parallelFor(cost_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t n = begin; n < end; ++n) {
      const auto h = static_cast<std::uint32_t>(n);
      if (!isEdge(h)) {
        cost_[n] = kNever;
      } else if (old_[n] != 0) {
        cost_[n] = costOf(h, best(h), rmsMm);
      }
      old_[n] = 0;
    }
  });
}

/// The cost below which a fifth of the edges lie, of the last few the least; kNever where none is left.
float Collapser::costOfPass() const {
  constexpr std::size_t kShare = 5;
  constexpr std::size_t kFew = 200;
  std::vector<float> costs;
  std::ranges::copy_if(cost_, std::back_inserter(costs), [](float cost) { return cost != kNever; });
  if (costs.empty()) {
    return kNever;
  }
  const auto last = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() < kFew ? 0 : costs.size() / kShare);
  std::ranges::nth_element(costs, last);
  return *last;
}

void Collapser::collapseIfCheap(std::uint32_t h, float most, double rmsMm) {
  const Collapse collapse = best(h);  // vertices around it may have moved since its cost was found
  // by error alone, what the pass allows is the limit
  cost_[h] = costOf(h, collapse, wanted_.empty() ? std::numeric_limits<double>::infinity() : rmsMm);
  if (!(cost_[h] <= most)) {
    return;
  }
  if (!connectivity_.canCollapse(h) || !keepsSides(h, collapse)) {
    cost_[h] = kNever;  // until something beside it changes
    return;
  }
  const std::uint32_t kept = connectivity_.origin(h);
  if (!wanted_.empty()) {
    wanted_[kept] = wantedEdge(h, collapse.place);
  }
  quadric_[kept] += quadric_[connectivity_.target(h)];
  position_[kept] = collapse.place;
  connectivity_.collapse(h);
  connectivity_.forEachOutgoing(kept, [&](std::uint32_t out) { old_[out] = old_[connectivity_.twin(out)] = 1; });
}

void Collapser::run(const CollapseLimit& limit, const ExecutionContext& context) {
  constexpr std::uint32_t kPoll = 4096;
  const std::size_t before = connectivity_.triangleCount();
  std::ranges::fill(old_, std::uint8_t{1});  // the limit may be another one than before
  while (connectivity_.triangleCount() > limit.triangles) {
    findCosts(limit.rmsMm, context);
    const float most = costOfPass();
    if (most == kNever) {
      break;
    }
    for (std::uint32_t h = 0; h < connectivity_.count() && connectivity_.triangleCount() > limit.triangles; ++h) {
      if (h % kPoll == 0) {
        context.throwIfCancelled();
      }
      if (cost_[h] <= most && isEdge(h)) {
        collapseIfCheap(h, most, limit.rmsMm);
      }
    }
    context.report(static_cast<double>(before - connectivity_.triangleCount()) / static_cast<double>(before), "simplify");
  }
}

SurfaceMesh Collapser::mesh() const {
  SurfaceMesh mesh;
  mesh.triangles = connectivity_.triangles();
  mesh.vertices = position_;
  for (Vec3& v : mesh.vertices) {
    v += centre_;
  }
  return mesh;
}

std::optional<SurfaceMesh> soundMesh(const Collapser& collapser, const ExecutionContext& context) {
  constexpr std::size_t kMostPairs = 200;
  constexpr double kVolumeShare = 1e-4;
  SurfaceMesh simplified = collapser.mesh();
  dropUnusedVertices(simplified);
  const double volume = signedVolumeMm3(simplified);
  if (untangle(simplified, kMostPairs, context).after > 0 || simplified.defects(context).any() ||
      std::abs(signedVolumeMm3(simplified) - volume) > kVolumeShare * std::abs(volume)) {
    return std::nullopt;
  }
  return simplified;
}

}  // namespace glisson
