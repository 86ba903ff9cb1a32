#pragma once
// Purpose: which models the paper's experiment makes of one label [Palomar 2016, 2.3 and 4.1; method.md 3 and 4], and two
// families beside them: simplified ones, and those of other methods (methods/methods.h).

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reconstruction/mcsd/mcsd.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {

/// Psr and Mcsd are the published families: normalisation, the best models and the published front are theirs alone.
enum class ModelFamily : std::uint8_t { Psr, Mcsd, SimplifiedPsr, Other };

inline constexpr int kDeepestPublished = 8;  ///< the greatest depth of the experiment, and the one that is simplified

/// How one model is made.
struct ModelRecipe {
  ModelFamily family = ModelFamily::Psr;
  int depth = 0;              ///< Psr: 5..8; SimplifiedPsr: 8, or the deepest that the label carries
  int smoothing = 0;          ///< Mcsd: iterations of the Laplacian filter
  int decimationPercent = 0;  ///< Mcsd: triangles to remove, before the smoothing
  int divisor = 1;            ///< SimplifiedPsr: one of so many triangles is kept
  std::string method = {};    ///< Other: id of a listed method
  std::string variant = {};   ///< Other: id of one of its variants

  bool operator==(const ModelRecipe&) const = default;
};

/// What all models of an experiment have in common.
struct ExperimentOptions {
  Sampling sampling = Sampling::Paper;
  double scale = 1.1;  ///< of Poisson's cube; the authors' base code has 1.25
  int timings = 1;     ///< runs of which the quickest one's seconds are kept; the paper takes three

  /// Throws UsageError.
  void validate() const;
};

/// In this order: PSR of depth 5 to 8, the 50 MCSD models (s = 0, 22, 45, 67, 90, each with e = 0, 10 .. 90 %), and PSR of depth 8
/// simplified to 1/4, 1/16, 1/32 and 1/64 of its triangles. A depth less has a quarter of the triangles, so the shares stand about
/// where depth 7, 6 and 5 do, and one between the last two, whatever the label's size. Then every variant of the listed methods.
std::vector<ModelRecipe> allRecipes();
/// Psr and Mcsd.
bool isPublished(ModelFamily family);

/// "psr", "mcsd", "simplified", "other": for files.
std::string_view familyId(ModelFamily family);
/// "psr", "mcsd", or a listed method's id: what made the surface.
std::string_view methodId(const ModelRecipe& recipe);
/// "psr_d7", "mcsd_s22_e90", "simplified_16", "mpu_e0.01": one for each recipe, for files.
std::string modelId(const ModelRecipe& recipe);
/// "PSR d=7", "MCSD s=22 e=90 %", "PSR d=8, 1/16", "MPU implicits eps=0.01": for people.
std::string modelName(const ModelRecipe& recipe);

PoissonParameters poissonOf(const ModelRecipe& recipe, const ExperimentOptions& options);
/// Laplacian, decimated first, normals not split: as shipped a mesh is measured beside (mesh/sharp_edges.h).
McsdParameters mcsdOf(const ModelRecipe& recipe);

}  // namespace glisson
