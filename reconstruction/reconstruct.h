#pragma once
// Purpose: one structure from mask to checked mesh: the call behind `glisson-cli reconstruct`, `model` and the window's jobs.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/structure_kind.h"
#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {

/// Listed: one of listedMethods() (methods/methods.h).
enum class Method : std::uint8_t { Psr, Mcsd, Listed };

/// The greatest depth of Poisson reconstruction.
inline constexpr int kDeepestPsr = 10;
/// The least side of a cell of an automatic depth, over the smallest spacing. With finer cells screened vessels fall into pieces
/// between the slices, with twice coarser ones thin branches are lost (docs/vessels.md).
inline constexpr double kAutoCell = 0.8;

struct ReconstructionParameters {
  Method method = Method::Psr;
  PoissonParameters psr;
  bool autoDepth = false;  ///< psr: the deepest up to kDeepestPsr with cells of kAutoCell or more; psr.depth is not looked at
  McsdParameters mcsd;
  std::string listedMethod;                ///< Listed: its id; of `psr` sampling and scale count
  std::string listedVariant;               ///< Listed: its id, or empty for the usual one
  std::optional<SimplifyTarget> simplify;  ///< behind any method

  void validate() const;
  /// `psr` with the depth to ask for.
  [[nodiscard]] PoissonParameters usedPsr() const;
  /// "PSR d=7 unbiased", "PSR d=auto unbiased", "MCSD sinc 10 decimation 25 %", "MPU implicits eps=0.01", "..., simplified to 10000
  /// triangles": for lists and reports.
  [[nodiscard]] std::string describe() const;
  /// Parenchyma by PSR d=7 unbiased, the others by MCSD sinc s=10 e=0.25.
  static ReconstructionParameters defaultsFor(StructureKind kind);
};

struct Seconds {
  double sample = 0, solve = 0, extract = 0, smooth = 0, decimate = 0, simplify = 0, check = 0;
  double selfIntersection = 0;  ///< searched behind smoothing, decimation and simplification, and undone where they are few
  [[nodiscard]] double total() const { return sample + solve + extract + smooth + decimate + simplify + check + selfIntersection; }
};

struct Reconstruction {
  SurfaceMesh mesh;
  ReconstructionParameters parameters;
  int usedDepth = 0;        ///< PSR and what divides a cube likewise; else 0
  std::size_t samples = 0;  ///< PSR only
  MeshDefects defects;
  double meshVolumeMl = 0;  ///< NaN where the mesh is open
  double voxelVolumeMl = 0;
  std::size_t maskComponents = 0;          ///< 26-connected components of the mask
  std::size_t meshComponents = 0;          ///< pieces that enclose volume (walls of cavities apart)
  std::optional<double> centrelineInside;  ///< vessels: share of the mask's centreline inside the mesh, 0..1
  std::vector<std::string> notes;       ///< components or cavities lost, Euler number, border contact, depth used, thin structure
  std::vector<std::string> deviations;  ///< volume or component deviations beyond the limits of method.md 3: export asks first
  Seconds seconds;

  [[nodiscard]] double volumeDeviation() const;  ///< mesh / voxels - 1
};

/// Reconstructs and checks (representation.h). MCSD meshes are freed of the few self-intersections that smoothing leaves behind
/// decimation (mesh/untangle.h, with a note); reconstructMcsd() alone is the untouched filter chain. `kind` decides the limits of
/// method.md 3 and whether the centreline is looked at. Throws ReconstructionError (empty mask), UsageError, Cancelled.
Reconstruction reconstruct(const Mask& mask, const ImageGeometry& geometry, StructureKind kind,
                           const ReconstructionParameters& parameters, const ExecutionContext& context = {});

/// Takes the reconstruction of set number `set`. May be called on several threads at once, in no fixed order.
using ReconstructionVisitor = std::function<void(std::size_t set, Reconstruction made)>;

/// reconstruct() of every set of parameters, the same meshes. MCSD sets share their stages (sweepMcsd()) and are checked on several
/// threads; PSR sets and those of listed methods are made one after the other. What the visitor has taken is kept no longer.
void reconstructEach(const Mask& mask, const ImageGeometry& geometry, StructureKind kind,
                     std::span<const ReconstructionParameters> sets, const ReconstructionVisitor& visit,
                     const ExecutionContext& context = {});

}  // namespace glisson
