#include "planning/exchange/package_islands.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/distance.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
/// The mesh encloses the point: its triangles fill the sphere of directions once (Van Oosterom and Strackee 1983).
bool encloses(const SurfaceMesh& mesh, const Vec3& p) {
  double solidAngle = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p;
    const Vec3 b = mesh.vertices[t[1]] - p;
    const Vec3 c = mesh.vertices[t[2]] - p;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    solidAngle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(solidAngle) > 2 * std::numbers::pi;
}

/// The closed surfaces a mesh is made of; those of cavities are turned inward.
std::vector<SurfaceMesh> shellsOf(const SurfaceMesh& mesh) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> component = componentOfTriangles(mesh, count);
  std::vector<SurfaceMesh> shells(count);
  std::vector<std::vector<std::uint32_t>> place(count, std::vector<std::uint32_t>(mesh.vertices.size(), 0));
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    SurfaceMesh& shell = shells[component[n]];
    Triangle corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& at = place[component[n]][mesh.triangles[n][c]];  // one more than its place; 0: not there yet
      if (at == 0) {
        shell.vertices.push_back(mesh.vertices[mesh.triangles[n][c]]);
        at = static_cast<std::uint32_t>(shell.vertices.size());
      }
      corners[c] = at - 1;
    }
    shell.triangles.push_back(corners);
  }
  return shells;
}

void append(SurfaceMesh& mesh, const SurfaceMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const Triangle& t : more.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

/// Takes the body around the island's point, with its cavities, out of a side's meshes. Nothing where there is none, where it is
/// all the side has, or where it is so much larger than the island's voxels that it must be more than the island.
std::optional<SurfaceMesh> takeOut(std::vector<SurfaceMesh>& pieces, const IslandAssessment& island) {
  constexpr double kMostOfIsland = 1.5;
  const double mostMm3 = (kMostOfIsland * island.volumeMl + kListedIslandMl) / kMlPerMm3;
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    std::vector<SurfaceMesh> shells = shellsOf(pieces[n]);
    const auto body = std::ranges::find_if(
        shells, [&](const SurfaceMesh& shell) { return signedVolumeMm3(shell) > 0 && encloses(shell, island.point); });
    if (body == shells.end()) {
      continue;
    }
    SurfaceMesh taken;
    SurfaceMesh rest;
    for (const SurfaceMesh& shell : shells) {
      const bool cavity = signedVolumeMm3(shell) < 0 && encloses(*body, shell.vertices.front());
      append(&shell == &*body || cavity ? taken : rest, shell);
    }
    if ((rest.empty() && pieces.size() == 1) || signedVolumeMm3(taken) > mostMm3) {
      return std::nullopt;
    }
    if (rest.empty()) {
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(n));
    } else {
      pieces[n] = std::move(rest);
    }
    return taken;
  }
  return std::nullopt;
}

/// The mesh without the triangles that lie on `body`.
void removeFacesOf(const SurfaceMesh& body, SurfaceMesh& surface) {
  constexpr double kSameMm = 0.01;  // both sides of a cut share its corners, up to the files' precision
  std::vector<Vec3> middles;
  middles.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    middles.emplace_back((surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3);
  }
  const std::vector<double> off = MeshDistance(body).to(middles);
  SurfaceMesh kept;
  for (std::size_t n = 0; n < off.size(); ++n) {
    if (off[n] <= kSameMm) {
      continue;
    }
    const auto first = static_cast<std::uint32_t>(kept.vertices.size());
    for (const std::uint32_t corner : surface.triangles[n]) {
      kept.vertices.push_back(surface.vertices[corner]);
    }
    kept.triangles.push_back({first, first + 1, first + 2});
  }
  surface = std::move(kept);
}

/// The resection on whose planes most of the piece lies.
std::size_t ownerOf(const SurfaceMesh& piece, const ResectionPlan& plan, AreaOnPlanes areaOnPlanes) {
  std::size_t owner = 0;
  double most = -1;
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    if (const double area = areaOnPlanes(piece, plan.resections[r].planes); area > most) {
      most = area;
      owner = r;
    }
  }
  return owner;
}

[[noreturn]] void hangsTogether(const Vec3& p) {
  throw PlanningError("The piece at (" + formatNumber(p[0], 1) + ", " + formatNumber(p[1], 1) + ", " + formatNumber(p[2], 1) +
                      ") mm is given to the other side, but on the surface it hangs together with the rest: give it back, or move "
                      "the plane, then export again.");
}
}  // namespace

void moveIslands(const std::vector<IslandAssessment>& islands, const ResectionPlan& plan, AreaOnPlanes areaOnPlanes,
                 std::vector<ResectedPart>& parts, std::vector<SurfaceMesh>& remnant) {
  for (const IslandAssessment& island : islands) {
    if (!island.assigned) {
      continue;
    }
    std::optional<SurfaceMesh> piece;
    if (island.side == PlanSide::Remnant) {
      piece = takeOut(remnant, island);
    }
    for (std::size_t r = 0; r < parts.size() && island.side == PlanSide::Resected && !piece; ++r) {
      piece = takeOut(parts[r].pieces, island);
    }
    if (!piece) {
      hangsTogether(island.point);
    }
    for (ResectedPart& part : parts) {
      removeFacesOf(*piece, part.surface);
    }
    if (island.side == PlanSide::Resected) {
      remnant.push_back(std::move(*piece));
    } else {
      parts[ownerOf(*piece, plan, areaOnPlanes)].pieces.push_back(std::move(*piece));
    }
  }
}

}  // namespace glisson
