#include "planning/volumetry/nearest_site.h"

#include <limits>
#include <stdexcept>

#include "reconstruction/parallel.h"

namespace glisson {

namespace {
/// One line of voxels along `axis`: the envelope of the parabolas that stand on its voxels.
class Line {
 public:
  explicit Line(int length)
      : sites_(static_cast<std::size_t>(length)),
        heights_(sites_.size()),
        places_(sites_.size()),
        starts_(sites_.size()),
        out_(sites_.size()) {}

  void set(std::size_t at, std::int32_t site, double height) {
    sites_[at] = site;
    heights_[at] = height;
  }

  /// The best site per voxel; `weight` is the axis' squared spacing.
  const std::vector<std::int32_t>& run(double weight) {
    std::size_t count = 0;
    for (std::size_t q = 0; q < sites_.size(); ++q) {
      if (sites_[q] == kNoSite) {
        continue;
      }
      double start = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        start = crossing(places_[count - 1], q, weight);
        if (start > starts_[count - 1]) {
          break;
        }
        --count;
        start = -std::numeric_limits<double>::infinity();
      }
      places_[count] = q;
      starts_[count++] = start;
    }
    std::size_t best = 0;
    for (std::size_t q = 0; q < sites_.size(); ++q) {
      while (best + 1 < count && starts_[best + 1] < static_cast<double>(q)) {
        ++best;
      }
      out_[q] = count > 0 ? sites_[places_[best]] : kNoSite;
    }
    return out_;
  }

 private:
  /// Where the parabola of `q` begins to be the lower one.
  [[nodiscard]] double crossing(std::size_t p, std::size_t q, double weight) const {
    const auto a = static_cast<double>(p);
    const auto b = static_cast<double>(q);
    return 0.5 * ((heights_[q] - heights_[p]) / (weight * (b - a)) + (a + b));
  }

  std::vector<std::int32_t> sites_;
  std::vector<double> heights_;
  std::vector<std::size_t> places_;
  std::vector<double> starts_;
  std::vector<std::int32_t> out_;
};

/// What the pass along `axis` has to know: the voxels' sites so far and what they are apart along the axes done before.
class Pass {
 public:
  Pass(const IndexBox& box, const Vec3& spacing, std::span<const Index3> sites, std::vector<std::int32_t>& nearest)
      : box_(box), squares_(spacing.cwiseProduct(spacing)), sites_(sites), nearest_(nearest) {
    stride_ = {1, static_cast<std::size_t>(box.size[0]),
               static_cast<std::size_t>(box.size[0]) * static_cast<std::size_t>(box.size[1])};
  }

  void run(std::size_t axis) {
    const std::size_t u = axis == 0 ? 1 : 0;
    const std::size_t v = axis == 2 ? 1 : 2;
    const auto across = static_cast<std::size_t>(box_.size[u]);
    parallelFor(static_cast<std::size_t>(box_.size[v]), 1, [&](std::size_t begin, std::size_t end) {
      Line line(box_.size[axis]);
      for (std::size_t b = begin; b < end; ++b) {
        for (std::size_t a = 0; a < across; ++a) {
          runLine(line, axis, {u, a}, {v, b});
        }
      }
    });
  }

 private:
  struct Place {
    std::size_t axis;
    std::size_t at;
  };

  void runLine(Line& line, std::size_t axis, Place a, Place b) {
    const std::size_t first = a.at * stride_[a.axis] + b.at * stride_[b.axis];
    Index3 voxel = box_.first;
    voxel[a.axis] += static_cast<int>(a.at);
    voxel[b.axis] += static_cast<int>(b.at);
    const auto length = static_cast<std::size_t>(box_.size[axis]);
    for (std::size_t n = 0; n < length; ++n) {
      const std::int32_t site = nearest_[first + n * stride_[axis]];
      line.set(n, site, site == kNoSite ? 0.0 : heightOf(site, voxel, axis));
    }
    const std::vector<std::int32_t>& best = line.run(squares_[static_cast<Eigen::Index>(axis)]);
    for (std::size_t n = 0; n < length; ++n) {
      nearest_[first + n * stride_[axis]] = best[n];
    }
  }

  /// Squared distance along the axes before `axis`.
  [[nodiscard]] double heightOf(std::int32_t site, const Index3& voxel, std::size_t axis) const {
    const Index3& place = sites_[static_cast<std::size_t>(site)];
    double sum = 0;
    for (std::size_t n = 0; n < axis; ++n) {
      const double d = voxel[n] - place[n];
      sum += squares_[static_cast<Eigen::Index>(n)] * d * d;
    }
    return sum;
  }

  const IndexBox& box_;
  Vec3 squares_;
  std::span<const Index3> sites_;
  std::vector<std::int32_t>& nearest_;
  std::array<std::size_t, 3> stride_{};
};
}  // namespace

std::vector<std::int32_t> nearestSites(const IndexBox& box, const Vec3& spacing, std::span<const Index3> sites,
                                       const ExecutionContext& context) {
  std::vector<std::int32_t> nearest(box.voxelCount(), kNoSite);
  for (std::size_t s = sites.size(); s-- > 0;) {
    std::size_t at = 0;
    for (std::size_t a = 3; a-- > 0;) {
      const int place = sites[s][a] - box.first[a];
      if (place < 0 || place >= box.size[a]) {
        throw std::invalid_argument("nearestSites: a site lies outside the box");
      }
      at = at * static_cast<std::size_t>(box.size[a]) + static_cast<std::size_t>(place);
    }
    nearest[at] = static_cast<std::int32_t>(s);  // from the last to the first: of two on one voxel the first stays
  }
  if (sites.empty() || nearest.empty()) {
    return nearest;
  }
  Pass pass(box, spacing, sites, nearest);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    context.throwIfCancelled();
    pass.run(axis);
  }
  return nearest;
}

}  // namespace glisson
