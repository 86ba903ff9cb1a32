#include "planning/volumetry/vessel_crossings.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "planning/volumetry/row_table.h"
#include "reconstruction/mesh/union_find.h"

namespace glisson {

namespace {
struct Span {
  double low = 0;
  double high = 0;
};

Span spanOf(const Polygon& polygon) {
  Span span{polygon[0][0], polygon[0][0]};
  for (const Vec3& p : polygon) {
    span.low = std::min(span.low, p[0]);
    span.high = std::max(span.high, p[0]);
  }
  return span;
}

/// Joins pieces of neighbouring rows whose extents along i come closer than half a voxel: vessels one voxel apart stay two.
UnionFind connect(const std::vector<CutPiece>& pieces, const VoxelRows& rows, double spacing) {
  UnionFind groups(pieces.size());
  const RowTable table(pieces.size(), [&](std::size_t n) { return rows.runs[pieces[n].run]; });
  std::vector<Span> spans;
  spans.reserve(pieces.size());
  for (const CutPiece& piece : pieces) {
    spans.push_back(spanOf(piece.polygon));
  }
  table.forEachRow([&](int j, int k, const RowTable::Range& row) {
    for (const RowTable::Range& other :
         {row, table.row(j + 1, k), table.row(j - 1, k + 1), table.row(j, k + 1), table.row(j + 1, k + 1)}) {
      for (std::size_t a = row.begin; a < row.end; ++a) {
        for (std::size_t b = other.begin; b < other.end; ++b) {
          if (spans[a].low < spans[b].high + 0.5 * spacing && spans[b].low < spans[a].high + 0.5 * spacing) {
            groups.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
          }
        }
      }
    }
  });
  return groups;
}

/// |cos| between `normal` and the vessel's main axis within `radius` of `centre`; 1 where there is no clear axis.
double obliquity(const VoxelRows& rows, const Vec3& spacing, const Vec3& centre, double radius, const Vec3& normal) {
  Vec3 sum = Vec3::Zero();
  Mat3 squares = Mat3::Zero();
  double count = 0;
  // The runs are by slices: only those within the ball are looked at.
  const auto first = std::partition_point(rows.runs.begin(), rows.runs.end(),
                                          [&](const RowRun& run) { return run.k * spacing[2] < centre[2] - radius; });
  for (auto at = first; at != rows.runs.end() && at->k * spacing[2] <= centre[2] + radius; ++at) {
    const RowRun& run = *at;
    const double y = run.j * spacing[1] - centre[1];
    const double z = run.k * spacing[2] - centre[2];
    if (y * y + z * z > radius * radius) {
      continue;
    }
    for (int i = run.i; i < run.i + run.n; ++i) {
      const Vec3 p(i * spacing[0] - centre[0], y, z);
      if (p.squaredNorm() <= radius * radius) {
        sum += p;
        squares += p * p.transpose();
        count += 1;
      }
    }
  }
  constexpr double kFewest = 8;
  if (count < kFewest) {
    return 1;
  }
  const Mat3 covariance = squares / count - (sum / count) * (sum / count).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(covariance);
  constexpr double kClear = 2;
  if (!(axes.eigenvalues()[2] > kClear * axes.eigenvalues()[1])) {
    return 1;
  }
  return std::abs(axes.eigenvectors().col(2).dot(normal));
}

struct Crossing {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  Index3 deepest{};      ///< of its voxels, that whose ball inside the vessel is the widest
  double radiusMm = -1;  ///< of that ball
};

/// Takes the voxels a piece lies in into account: one row's, from the first to the last it reaches.
void keepDeepest(const Span& span, const RowRun& run, double spacing, const InscribedBalls& balls, Crossing& crossing) {
  const auto voxel = [&](double mm) { return std::clamp(static_cast<int>(std::lround(mm / spacing)), run.i, run.i + run.n - 1); };
  for (int i = voxel(span.low); i <= voxel(span.high); ++i) {
    const double radius = balls.radiusAt({i, run.j, run.k});
    if (radius > crossing.radiusMm) {
      crossing.radiusMm = radius;
      crossing.deepest = {i, run.j, run.k};
    }
  }
}

double diameterOf(double area) { return 2 * std::sqrt(area / std::numbers::pi); }
}  // namespace

std::vector<VesselCrossing> vesselCrossings(const std::string& id, const std::string& name, const VoxelRows& rows,
                                            const std::vector<CutPiece>& pieces, const InscribedBalls& balls,
                                            const ImageGeometry& geometry) {
  const Vec3& spacing = geometry.spacing;
  UnionFind groups = connect(pieces, rows, spacing[0]);
  std::map<std::uint32_t, Crossing> found;
  for (std::uint32_t n = 0; n < pieces.size(); ++n) {
    const Polygon& polygon = pieces[n].polygon;
    const double area = areaOf(polygon);
    const Vec3 middle = std::accumulate(polygon.begin(), polygon.end(), Vec3(0, 0, 0)) / static_cast<double>(polygon.size());
    Crossing& crossing = found[groups.find(n)];
    crossing.area += area;
    crossing.moment += area * middle;
    crossing.normal += area * pieces[n].normal;
    keepDeepest(spanOf(polygon), rows.runs[pieces[n].run], spacing[0], balls, crossing);
  }
  constexpr double kGrazed = 0.5;  // of the calibre: a smaller opening lies in the wall only
  std::vector<VesselCrossing> crossings;
  for (const auto& [first, crossing] : found) {
    if (!(crossing.area > 0)) {
      continue;
    }
    const Vec3 centre = crossing.moment / crossing.area;
    const double calibre = balls.calibreAround(crossing.deepest);
    const double radius = std::max(1.5 * std::max(diameterOf(crossing.area), calibre), 3 * spacing.maxCoeff());
    const double cosine = obliquity(rows, spacing, centre, radius, crossing.normal.normalized());
    const double opened = diameterOf(crossing.area * cosine);
    const bool runsAlong = cosine < kAlongCosine || opened < kGrazed * calibre;
    crossings.push_back({id, name, geometry.origin + geometry.direction * centre, std::max(opened, calibre), runsAlong});
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const VesselCrossing& a, const VesselCrossing& b) { return a.diameterMm > b.diameterMm; });
  return crossings;
}

}  // namespace glisson
