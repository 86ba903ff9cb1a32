#pragma once
// Purpose: the solution of S X = f on the nested levels by cascadic iteration (Deuflhard 1994; Bornemann and Deuflhard 1996): each
// level starts from the coarser level's solution, whose error is rough, and needs only a few steps.

#include <vector>

#include "reconstruction/poisson/hierarchy.h"

namespace glisson::poisson {

/// Solves every level from coarse to fine; leaves x on every level and takes f away.
void solveLevels(const CubeSamples& samples, const HierarchyOptions& options, std::vector<Level>& levels,
                 const ExecutionContext& context);

/// `steps` of the Chebyshev iteration (Golub and Varga 1961) on S x = f, which damps error whose eigenvalues lie in
/// [kLargestEigenvalue / `condition`, kLargestEigenvalue]. x is the start and the result; fixed nodes keep their value.
void chebyshev(const BlockGrid& grid, const Field& f, Field& x, int steps, float condition, const ExecutionContext& context);

/// At most `steps` of conjugate gradients (Hestenes and Stiefel 1952) on (S + screening) x = f, until the residual has fallen by
/// 1e-5.
void conjugateGradients(const CubeSamples& samples, const HierarchyOptions& options, Level& level, int steps,
                        const ExecutionContext& context);

}  // namespace glisson::poisson
