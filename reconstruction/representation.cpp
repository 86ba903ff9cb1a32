#include "reconstruction/representation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reconstruction/cancel_poll.h"
#include "reconstruction/image/liver_voxels.h"
#include "reconstruction/mesh/centreline.h"
#include "reconstruction/mesh/inside_rows.h"
#include "reconstruction/mesh/mask_pieces.h"
#include "reconstruction/mesh/union_find.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
/// The volume deviation method.md 3 allows a structure of this kind, as a share of its voxel volume.
double allowedVolumeDeviation(StructureKind kind, double voxelVolumeMl) {
  constexpr double kTumourFloorMl = 0.05;
  if (kind == StructureKind::Liver) {
    return 0.002;
  }
  return isLesion(kind) ? std::max(0.02, kTumourFloorMl / voxelVolumeMl) : 0.03;
}

std::string signedPercent(double share) {
  const double percent = 100.0 * share;
  const int decimals = std::abs(percent) < 1.0 ? 2 : 1;
  return (percent < 0 ? "-" : "+") + formatNumber(std::abs(percent), decimals) + " %";
}

std::string counted(std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

/// "120, 7 and 1 voxels": the greatest few.
std::string voxelList(std::vector<std::size_t> voxels) {
  constexpr std::size_t kShown = 5;
  std::sort(voxels.rbegin(), voxels.rend());
  std::string text;
  for (std::size_t n = 0; n < std::min(voxels.size(), kShown); ++n) {
    text += (n == 0 ? "" : ", ") + std::to_string(voxels[n]);
  }
  if (voxels.size() > kShown) {
    text += ", ...";
  }
  return text + (voxels.size() == 1 && voxels[0] == 1 ? " voxel" : " voxels");
}

/// Pieces of the mesh that enclose volume, and walls of cavities, which enclose less than none.
struct Walls {
  std::size_t outer = 0;
  std::size_t inner = 0;
};

Walls wallsOf(const SurfaceMesh& mesh, const ExecutionContext& context) {
  UnionFind sets(mesh.vertices.size());
  CancelPoll poll(context);
  for (const Triangle& t : mesh.triangles) {
    poll();
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  }
  std::vector<double> volume(mesh.vertices.size(), 0.0);
  const Vec3 centre = mesh.vertices.front();
  for (const Triangle& t : mesh.triangles) {
    poll();
    const auto at = [&](std::size_t n) -> Vec3 { return mesh.vertices[t[n]] - centre; };
    volume[sets.find(t[0])] += at(0).dot(at(1).cross(at(2)));
  }
  const auto count = [&](auto matches) { return static_cast<std::size_t>(std::count_if(volume.begin(), volume.end(), matches)); };
  return {.outer = count([](double v) { return v > 0; }), .inner = count([](double v) { return v < 0; })};
}

/// V - E + F of a closed edge-manifold mesh, whose edges are three for two triangles.
long long closedEuler(const SurfaceMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  return static_cast<long long>(std::count(used.begin(), used.end(), 1)) - static_cast<long long>(mesh.triangles.size()) / 2;
}

/// Voxels of each piece that lie inside the mesh.
std::vector<std::size_t> insideOf(const Pieces& pieces, const InsideRows& rows) {
  std::vector<std::size_t> inside(pieces.count(), 0);
  for (const VoxelRun& run : pieces.runs) {
    inside[run.piece] += static_cast<std::size_t>(rows.insideOf(run));
  }
  return inside;
}

void checkPieces(const MaskFacts& facts, const InsideRows& rows, Reconstruction& made) {
  const Pieces& pieces = facts.pieces;
  const auto inside = insideOf(pieces, rows);
  std::vector<std::size_t> lost;
  for (std::size_t n = 0; n < pieces.count(); ++n) {
    if (inside[n] == 0) {
      lost.push_back(pieces.voxels[n]);
    }
  }
  if (!lost.empty()) {
    made.notes.push_back(counted(lost.size(), "piece", "pieces") + " of " + std::to_string(pieces.count()) +
                         " lost: " + voxelList(lost));
    std::erase_if(lost, [](std::size_t voxels) { return voxels < kPieceThatMatters; });
    if (!lost.empty()) {
      made.deviations.push_back(counted(lost.size(), "piece", "pieces") + " lost: " + voxelList(lost));
    }
  }
  if (made.meshComponents < pieces.count() || made.meshComponents > facts.joinedByFaces) {
    made.notes.push_back(counted(made.meshComponents, "piece", "pieces") + " in the mesh, " + std::to_string(pieces.count()) +
                         " in the mask");
  }
}

void checkCavities(const Mask& mask, const Pieces& cavities, const InsideRows& rows, std::size_t innerWalls, Reconstruction& made) {
  const auto inside = insideOf(cavities, rows);
  std::vector<std::size_t> lost;
  for (std::size_t n = 0; n < cavities.count(); ++n) {
    if (inside[n] == cavities.voxels[n]) {
      lost.push_back(cavities.voxels[n]);
    }
  }
  if (!lost.empty()) {
    made.notes.push_back(counted(lost.size(), "cavity", "cavities") + " of " + std::to_string(cavities.count()) +
                         " not represented: " + voxelList(lost));
  }
  // What touches the outside by a corner is no cavity for certain.
  if (innerWalls + lost.size() < cavities.count()) {
    const std::size_t closed = cavitiesOf(mask, Neighbours::TwentySix).count();
    if (innerWalls + lost.size() < closed) {
      made.notes.push_back(counted(innerWalls, "cavity", "cavities") + " in the mesh, " + std::to_string(closed) +
                           " in the mask: thin walls are open");
    }
  }
  if (innerWalls > cavities.count()) {
    made.notes.push_back(counted(innerWalls, "cavity", "cavities") + " in the mesh, " + std::to_string(cavities.count()) +
                         " in the mask");
  }
}

void checkEuler(const EulerNumbers& euler, Reconstruction& made) {
  const long long ofMesh = closedEuler(made.mesh);
  const auto [least, most] = std::minmax({euler.facesEdgesCorners, euler.facesEdges, euler.faces, euler.facesAsCubes});
  if (ofMesh < 2 * least || ofMesh > 2 * most) {
    made.notes.push_back("Euler number " + std::to_string(ofMesh) + ", the mask's " + std::to_string(2 * least) +
                         (least == most ? "" : " to " + std::to_string(2 * most)));
  }
}

/// How many voxels on from a set voxel, both ways along an axis, are set; stops at `enough`.
int extentAlong(const Mask& mask, Index3 at, std::size_t axis, int enough) {
  int extent = 1;
  for (const int step : {-1, 1}) {
    Index3 other = at;
    for (other[axis] += step; extent < enough && mask.at(other[0], other[1], other[2]); other[axis] += step) {
      ++extent;
    }
  }
  return extent;
}

/// Pieces that are nowhere as wide as `widthMm` along all three axes at once, looked for at the middle of every run.
void noteThinPieces(const Mask& mask, const ImageGeometry& geometry, const Pieces& pieces, double cellMm, Reconstruction& made) {
  const double widthMm = 3.0 * cellMm;
  std::vector<std::uint8_t> wide(pieces.count(), 0);
  const auto enough = [&](std::size_t axis) {
    return static_cast<int>(std::ceil(widthMm / geometry.spacing[static_cast<Eigen::Index>(axis)]));
  };
  for (const VoxelRun& run : pieces.runs) {
    if (wide[run.piece] != 0 || run.length() < enough(0)) {
      continue;
    }
    const Index3 middle{(run.begin + run.end) / 2, run.j, run.k};
    wide[run.piece] = extentAlong(mask, middle, 1, enough(1)) >= enough(1) && extentAlong(mask, middle, 2, enough(2)) >= enough(2);
  }
  std::vector<std::size_t> thin;
  for (std::size_t n = 0; n < pieces.count(); ++n) {
    if (wide[n] == 0) {
      thin.push_back(pieces.voxels[n]);
    }
  }
  if (!thin.empty()) {
    made.notes.push_back(counted(thin.size(), "piece", "pieces") + " thinner than three cells (" + formatNumber(widthMm, 1) +
                         " mm): " + voxelList(thin));
  }
}

void checkCentreline(const std::vector<Index3>& line, const InsideRows& rows, Reconstruction& made) {
  const auto inside = std::count_if(line.begin(), line.end(), [&](const Index3& v) { return rows.isInside(v[0], v[1], v[2]); });
  made.centrelineInside = static_cast<double>(inside) / static_cast<double>(line.size());
  if (*made.centrelineInside < kCentrelineShare) {
    made.notes.push_back("only " + formatNumber(100.0 * *made.centrelineInside, 1) + " % of the centreline lies inside the mesh");
  }
}
/// A mesh of a reconstruction looked at by itself.
struct MeshFacts {
  MeshDefects defects;
  Walls walls;
  std::optional<InsideRows> rows;  ///< all corners of a reconstruction's triangles are vertices, so this works on open ones too
};

/// Mask and mesh side by side: most of it runs on one thread each.
MeshFacts lookAt(const Mask& mask, const ImageGeometry& geometry, StructureKind kind, const SurfaceMesh& mesh,
                 std::optional<MaskFacts>& facts, const ExecutionContext& context) {
  MeshFacts found;
  std::optional<MaskFacts> fresh;
  parallelFor(4, 1, [&](std::size_t task, std::size_t) {
    context.throwIfCancelled();
    if (task == 0) {
      found.defects = mesh.defects(context);
    } else if (task == 1 && !facts) {
      fresh = factsOf(mask, kind, context);
    } else if (task == 2 && !mesh.triangles.empty()) {
      found.walls = wallsOf(mesh, context);
    } else if (task == 3 && !mesh.triangles.empty()) {
      found.rows.emplace(mesh, geometry, context);
    }
  });
  if (fresh) {
    facts = std::move(fresh);
  }
  return found;
}
}  // namespace

MaskFacts factsOf(const Mask& mask, StructureKind kind, const ExecutionContext& context) {
  MaskFacts facts;
  parallelFor(5, 1, [&](std::size_t task, std::size_t) {
    context.throwIfCancelled();
    if (task == 0) {
      facts.pieces = piecesOf(mask, Neighbours::TwentySix, context);
    } else if (task == 1) {
      facts.joinedByFaces = piecesOf(mask, Neighbours::Six, context).count();
    } else if (task == 2) {
      facts.cavities = cavitiesOf(mask, Neighbours::Six, context);
    } else if (task == 3) {
      facts.euler = eulerNumbers(mask, context);
    } else if (isVessel(kind)) {
      facts.centreline = centrelineOf(mask, context);
    }
  });
  return facts;
}

void checkAgainstMask(const Mask& mask, const ImageGeometry& geometry, StructureKind kind, double psrCellMm,
                      std::optional<MaskFacts>& facts, Reconstruction& made, const ExecutionContext& context) {
  const MeshFacts found = lookAt(mask, geometry, kind, made.mesh, facts, context);
  const std::size_t selfIntersections = made.defects.selfIntersections;
  made.defects = found.defects;
  made.defects.selfIntersections = selfIntersections;
  made.voxelVolumeMl = static_cast<double>(mask.count()) * geometry.voxelVolumeMm3() * kMlPerMm3;
  const Pieces& pieces = facts->pieces;
  made.maskComponents = pieces.count();
  if (mask.touchesBorder(geometry.size)) {
    made.notes.emplace_back("touches the border of the image and is cut off there");
  }
  const int asked = made.parameters.psr.depth;
  if (made.parameters.method == Method::Psr && !made.parameters.autoDepth && made.usedDepth < asked) {
    made.notes.push_back("depth " + std::to_string(made.usedDepth) + " used instead of " + std::to_string(asked) +
                         ": finer cells would be below half a voxel");
  }
  if (psrCellMm > 0) {
    noteThinPieces(mask, geometry, pieces, psrCellMm, made);
  }
  const MeshDefects& defects = made.defects;
  if (defects.noTriangles || defects.openEdges > 0 || defects.orientationEdges > 0) {
    // An open surface has no inside to compare; the defects say so.
    made.meshVolumeMl = std::numeric_limits<double>::quiet_NaN();
    std::uint32_t count = 0;
    componentOfTriangles(made.mesh, count);
    made.meshComponents = count;
  } else {
    made.meshVolumeMl = signedVolumeMm3(made.mesh, context) * kMlPerMm3;
    made.meshComponents = found.walls.outer;
    context.throwIfCancelled();
    checkPieces(*facts, *found.rows, made);
    checkCavities(mask, facts->cavities, *found.rows, found.walls.inner, made);
    if (defects.nonManifoldEdges == 0) {
      checkEuler(facts->euler, made);
    }
    if (isVessel(kind)) {
      checkCentreline(facts->centreline, *found.rows, made);
    }
  }
  if (std::abs(made.volumeDeviation()) > allowedVolumeDeviation(kind, made.voxelVolumeMl)) {
    made.deviations.push_back("volume " + signedPercent(made.volumeDeviation()) + " against the voxels");
  }
}

}  // namespace glisson
