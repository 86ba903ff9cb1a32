#include "reconstruction/mesh/half_edges.h"

#include <algorithm>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/edges.h"

namespace glisson {

HalfEdges::HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles, const ExecutionContext& context)
    : origin_(3 * triangles.size()),
      twin_(3 * triangles.size(), kDead),
      outgoing_(vertexCount, kDead),
      mark_(vertexCount, 0),
      triangles_(triangles.size()) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      origin_[3 * t + k] = triangles[t][k];
      outgoing_[triangles[t][k]] = static_cast<std::uint32_t>(3 * t + k);
    }
  }
  const MeshEdges edges(vertexCount, triangles, context);
  context.throwIfCancelled();
  bool closed = true;
  edges.forEachEdge([&](std::span<const MeshEdges::Side> sides) {
    if (sides.size() != 2 || sides[0].along() == sides[1].along()) {
      closed = false;
      return;
    }
    twin_[sides[0].corner()] = sides[1].corner();
    twin_[sides[1].corner()] = sides[0].corner();
  });
  if (!closed || std::ranges::find(twin_, kDead) != twin_.end() ||
      countVerticesOfSeveralFans(vertexCount, triangles, edges, context) > 0) {
    throw CheckFailed("The surface is not a closed manifold, so it cannot be simplified; reconstruct it again.");
  }
}

bool HalfEdges::canCollapse(std::uint32_t h) {
  const std::uint32_t o = twin_[h];
  ++round_;
  forEachOutgoing(origin_[h], [&](std::uint32_t out) { mark_[target(out)] = round_; });
  int shared = 0;
  forEachOutgoing(origin_[o], [&](std::uint32_t out) { shared += mark_[target(out)] == round_ ? 1 : 0; });
  if (shared != 2) {
    return false;
  }
  // The two apexes lose an edge each: with fewer than three left their triangles would lie on each other.
  for (const std::uint32_t side : {h, o}) {
    int valence = 0;
    forEachOutgoing(apex(side), [&](std::uint32_t /*out*/) { ++valence; });
    if (valence < 4) {
      return false;
    }
  }
  return true;
}

/// Removes h's triangle, whose other two sides lie on each other now.
void HalfEdges::closeTriangle(std::uint32_t h) {
  const std::uint32_t a = twin_[next(h)];      // from the apex
  const std::uint32_t b = twin_[previous(h)];  // to the apex
  twin_[a] = b;
  twin_[b] = a;
  outgoing_[origin_[a]] = a;
  outgoing_[origin_[b]] = b;
  origin_[h] = origin_[next(h)] = origin_[previous(h)] = kDead;
  --triangles_;
}

void HalfEdges::collapse(std::uint32_t h) {
  const std::uint32_t o = twin_[h];
  const std::uint32_t kept = origin_[h];
  forEachOutgoing(origin_[o], [&](std::uint32_t out) { origin_[out] = kept; });
  closeTriangle(h);
  closeTriangle(o);
}

std::vector<Triangle> HalfEdges::triangles() const {
  std::vector<Triangle> left;
  left.reserve(triangles_);
  for (std::size_t h = 0; h < origin_.size(); h += 3) {
    if (origin_[h] != kDead) {
      left.push_back({origin_[h], origin_[h + 1], origin_[h + 2]});
    }
  }
  return left;
}

}  // namespace glisson
