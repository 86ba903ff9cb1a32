#include "planning/exchange/package_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "planning/exchange/package_islands.h"
#include "reconstruction/errors.h"
#include "reconstruction/mesh/cut.h"
#include "reconstruction/mesh/edges.h"
#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

constexpr Rgb kResectedColour{160, 160, 160};
constexpr Rgb kSurfaceColour{240, 240, 240};
/// cutForFloats() leaves a cut's corners this near to its plane, in units of floatSpacingMm().
constexpr double kOnPlaneSpacings = 10;
/// ... and moves nothing farther than this for each plane.
constexpr double kMovedSpacings = 40;

std::string numbered(const std::string& stem, std::size_t number) {
  return stem + (number < 10 ? "_0" : "_") + std::to_string(number);
}

/// "portal_vein" -> "Portal vein", "tumour_01" -> "Tumour 1".
std::string nameFromId(const std::string& id) {
  std::string name;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const bool padding = id[i] == '0' && i > 0 && id[i - 1] == '_' && i + 1 < id.size();
    if (!padding) {
      name += id[i] == '_' ? ' ' : id[i];
    }
  }
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') {
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
  }
  return name;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

void requireSound(const Structure& structure, const ExecutionContext& context) {
  if (!structure.reconstruction) {
    throw PlanningError("The structure \"" + structure.id + "\" has not been built yet: let its model finish, then export again.");
  }
  const SurfaceMesh& mesh = structure.reconstruction->mesh;
  MeshDefects defects = mesh.defects();
  if (!defects.any()) {
    defects.selfIntersections = countSelfIntersections(mesh, context);
  }
  if (defects.any()) {
    throw CheckFailed("The structure \"" + structure.id + "\" has defects (" + joined(defects.names()) +
                      ") and is not exported: reconstruct it with other parameters.");
  }
}

void requireAccepted(const LiverModel& model, const ExportOptions& options) {
  std::vector<std::string> deviating;
  for (const Structure& structure : model.structures) {
    if (structure.reconstruction && !structure.reconstruction->deviations.empty()) {
      deviating.push_back(structure.id + " (" + joined(structure.reconstruction->deviations) + ")");
    }
  }
  if (!deviating.empty() && !options.acceptDeviations) {
    throw PlanningError("Structures deviate from their voxels: " + joined(deviating) +
                        "; look at them and accept them with --accept-deviations, or reconstruct them with other parameters.");
  }
}

PackageMesh part(const std::string& id, const std::string& role, int resection, Rgb colour, bool closed, SurfaceMesh mesh) {
  PackageMesh result;
  result.named = {id, nameFromId(id), colour, 1.0, std::move(mesh)};
  result.role = role;
  result.closed = closed;
  result.resection = resection;
  return result;
}

/// The plane, or the surface it is bent to.
CuttingSurface surfaceOf(const ResectionPlane& plane) {
  if (!plane.bend) {
    return {plane, [plane](const Vec3& p) { return plane.normal.dot(p - plane.origin); }, 0};
  }
  const BentSurface bent(plane);
  return {plane, [bent](const Vec3& p) { return bent.above(p); }, bent.shape().mostCurved()};
}

/// Whether some of the mesh lies beside the bend's square, where the surface levels out and is curved more.
bool reachesBorder(const SurfaceMesh& mesh, const BentSurface& bent) {
  const double half = bent.shape().halfSizeMm();
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& p) {
    return std::abs(bent.u().dot(p - bent.origin())) > half || std::abs(bent.v().dot(p - bent.origin())) > half;
  });
}

CutResult cutAlong(const SurfaceMesh& mesh, const ResectionPlane& plane, const ExecutionContext& context) {
  if (!plane.bend) {
    return cutForFloats(mesh, HalfSpace(plane), context);
  }
  CuttingSurface surface = surfaceOf(plane);
  if (const BentSurface bent(plane); !reachesBorder(mesh, bent)) {
    surface.mostCurved = bent.shape().mostCurvedInside();
  }
  return cutForFloats(mesh, surface, context);
}

/// Whether a part's triangle lies on the plane. A later cut divides the triangles of a bent plane's cap along their chords, so its
/// corners may be as far off as the cap itself; such a triangle faces as the surface does.
class OnPlane {
 public:
  OnPlane(const ResectionPlane& plane, double onPlaneMm) : surface_(surfaceOf(plane)), onPlaneMm_(onPlaneMm) {
    if (plane.bend) {
      bent_.emplace(plane);
    }
  }

  [[nodiscard]] bool holds(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const double off = std::max({std::abs(surface_.above(a)), std::abs(surface_.above(b)), std::abs(surface_.above(c))});
    if (off <= onPlaneMm_ || !bent_ || off > kOnBentMm) {
      return off <= onPlaneMm_;
    }
    const Vec3 normal = (b - a).cross(c - a).normalized();
    return std::abs(normal.dot(bent_->tangentAt((a + b + c) / 3).normal)) > kAlongBent;
  }

 private:
  static constexpr double kOnBentMm = 1.5 * kCurvedCutMm;
  static constexpr double kAlongBent = 0.9;  // cosine
  CuttingSurface surface_;
  std::optional<BentSurface> bent_;
  double onPlaneMm_;
};

/// The triangles of a resected part that lie on one of the resection's planes, turned to face the resected side.
void addFacesOnPlanes(const SurfaceMesh& resected, const std::vector<ResectionPlane>& planes, SurfaceMesh& surface) {
  const double onPlaneMm = kOnPlaneSpacings * floatSpacingMm(resected);
  std::vector<OnPlane> surfaces;
  surfaces.reserve(planes.size());
  for (const ResectionPlane& plane : planes) {
    surfaces.emplace_back(plane, onPlaneMm);
  }
  const auto& v = resected.vertices;
  for (const Triangle& t : resected.triangles) {
    if (std::any_of(surfaces.begin(), surfaces.end(), [&](const OnPlane& on) { return on.holds(v[t[0]], v[t[1]], v[t[2]]); })) {
      const auto n = static_cast<std::uint32_t>(surface.vertices.size());
      for (const std::uint32_t corner : {t[0], t[2], t[1]}) {
        surface.vertices.push_back(v[corner]);
      }
      surface.triangles.push_back({n, n + 1, n + 2});
    }
  }
}

struct Pieces {
  std::vector<SurfaceMesh> inside;
  std::vector<SurfaceMesh> outside;
  SurfaceMesh surface;
};

/// Each closed piece cut by each plane in turn: inside is what lies within all half-spaces.
Pieces cutByAll(const std::vector<SurfaceMesh>& pieces, const std::vector<ResectionPlane>& planes,
                const ExecutionContext& context) {
  Pieces result;
  for (const SurfaceMesh& piece : pieces) {
    SurfaceMesh inside = piece;
    for (const ResectionPlane& plane : planes) {
      if (inside.empty()) {
        break;
      }
      CutResult halves = cutAlong(inside, plane, context);
      if (!halves.negative.empty()) {
        result.outside.push_back(std::move(halves.negative));
      }
      inside = std::move(halves.positive);
      // One plane through one piece: the cut as it was made, capped once.
      if (planes.size() == 1 && pieces.size() == 1) {
        result.surface = std::move(halves.section);
      }
    }
    if (!inside.empty()) {
      result.inside.push_back(std::move(inside));
    }
  }
  if (result.surface.empty()) {
    for (const SurfaceMesh& piece : result.inside) {
      addFacesOnPlanes(piece, planes, result.surface);
    }
  }
  return result;
}

void addPieces(std::vector<PackageMesh>& meshes, const std::string& id, const std::string& role, int resection, Rgb colour,
               std::vector<SurfaceMesh>&& pieces) {
  const bool several = pieces.size() > 1;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    meshes.push_back(part(several ? numbered(id, i + 1) : id, role, resection, colour, true, std::move(pieces[i])));
  }
}

double volumeOf(const std::vector<SurfaceMesh>& pieces) {
  double sum = 0;
  for (const SurfaceMesh& piece : pieces) {
    sum += signedVolumeMm3(piece);
  }
  return sum;
}

double areaOnPlanes(const SurfaceMesh& piece, const std::vector<ResectionPlane>& planes) {
  SurfaceMesh faces;
  addFacesOnPlanes(piece, planes, faces);
  return areaMm2(faces);
}

void addPlannedParts(const Structure& parenchyma, const ResectionPlan& plan, const std::vector<IslandAssessment>& islands,
                     const ExecutionContext& context, std::vector<PackageMesh>& meshes) {
  // Cut as the file holds it: a sliver beside the cut that a later rounding turned over would be a self-intersection.
  std::vector<SurfaceMesh> remnant{roundedToFloat(parenchyma.reconstruction->mesh)};
  splitFans(remnant.front());
  const double whole = volumeOf(remnant);
  const double moved = kMovedSpacings * floatSpacingMm(remnant.front()) * areaMm2(remnant.front());
  std::size_t cuts = 0;
  double resectedVolume = 0;
  std::vector<ResectedPart> parts;
  for (std::size_t r = 0; r < plan.resections.size(); ++r) {
    const std::vector<ResectionPlane>& planes = plan.resections[r].planes;
    Pieces pieces = planes.empty() ? Pieces{} : cutByAll(remnant, planes, context);
    if (pieces.inside.empty() || pieces.outside.empty() || pieces.surface.empty()) {
      throw PlanningError("Resection " + std::to_string(r + 1) +
                          " of the plan does not divide the liver, so there is no resected part: move its plane into the liver or "
                          "remove the resection, then export again.");
    }
    resectedVolume += volumeOf(pieces.inside);
    parts.push_back({std::move(pieces.inside), std::move(pieces.surface)});
    remnant = std::move(pieces.outside);
    cuts += planes.size();
  }
  // Each cut has conserved the volume of the mesh it moved; the moves together are no more than this.
  if (!(std::abs(resectedVolume + volumeOf(remnant) - whole) <= static_cast<double>(cuts) * moved)) {
    throw CheckFailed("The resected parts and the remnant do not add up to the liver: move the plane a little and export again.");
  }
  moveIslands(islands, plan, areaOnPlanes, parts, remnant);
  addPieces(meshes, "remnant", "remnant", -1, parenchyma.colour, std::move(remnant));
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const int number = static_cast<int>(r);
    addPieces(meshes, numbered("resected", r + 1), "resected", number, kResectedColour, std::move(parts[r].pieces));
    meshes.push_back(part(numbered("resection_surface", r + 1), "resection surface", number, kSurfaceColour, false,
                          std::move(parts[r].surface)));
  }
}

}  // namespace

std::vector<PackageMesh> packageMeshes(const Case& source, const ResectionPlan& plan, const std::vector<IslandAssessment>& islands,
                                       const ExportOptions& options, const ExecutionContext& context) {
  const Structure* parenchyma = source.model ? source.model->find("parenchyma") : nullptr;
  if (parenchyma == nullptr) {
    throw PlanningError("The model has no parenchyma, so there is nothing to export: build the model first.");
  }
  requireAccepted(*source.model, options);
  std::vector<PackageMesh> meshes;
  const std::vector<Structure>& structures = source.model->structures;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const double count = static_cast<double>(structures.size());
    requireSound(structures[i], context.range(static_cast<double>(i) / count * 0.8, static_cast<double>(i + 1) / count * 0.8));
    PackageMesh mesh = part(structures[i].id, "structure", -1, structures[i].colour, true, structures[i].reconstruction->mesh);
    mesh.named.opacity = structures[i].opacity;
    meshes.push_back(std::move(mesh));
    context.throwIfCancelled();
  }
  if (!plan.resections.empty()) {
    addPlannedParts(*parenchyma, plan, islands, context.range(0.8, 1.0), meshes);
  }
  for (PackageMesh& mesh : meshes) {
    if (mesh.role == "remnant" || mesh.role == "resected") {  // vessels and tumours are seen through the parts as through the liver
      mesh.named.opacity = parenchyma->opacity;
    }
  }
  return meshes;
}

}  // namespace glisson
