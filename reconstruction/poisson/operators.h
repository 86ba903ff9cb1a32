#pragma once
// Purpose: the finite-element operators between and on nested grids of trilinear B-splines phi. On a level with cell h:
//   S   stiffness over h:    S_ij = 1/h int grad phi_i . grad phi_j = K x M x M + M x K x M + M x M x K,
//                            K = [-1 2 -1], M = [1 4 1]/6; its eigenvalues lie in (0, 4]
//   G   divergence over h^2: (G V)_i = 1/h^2 int V . grad phi_i = sum over axes of D x M x M V_a, D = [1 0 -1]/2
//   P   prolongation: the coarse function on the fine grid, [1/2 1 1/2] per axis; P^T its transpose
// laplace X = div V in weak form is S X = f with f = h G V (V a density, 1/mm; h in mm). Nested: S_coarse = P^T S P / 2 and
// f_coarse = P^T f / 2. All poll cancel every few dozen blocks.

#include "reconstruction/execution_context.h"
#include "reconstruction/poisson/block_grid.h"

namespace glisson::poisson {

inline constexpr float kLargestEigenvalue = 4.0F;  ///< of S

using VectorField = std::array<Field, 3>;

/// out = S u on the unknowns, 0 on fixed nodes.
void applyStiffness(const BlockGrid& grid, const Field& u, Field& out, const ExecutionContext& context);
/// One step of a three-term iteration in a single walk through memory: x + momentum (x - before) + step (f - S x) on the unknowns,
/// x on fixed nodes, is written into `before`, which is not read where momentum is 0.
void iterate(const BlockGrid& grid, const Field& x, const Field& f, float momentum, float step, Field& before,
             const ExecutionContext& context);
/// f = factor * G v.
void divergence(const BlockGrid& grid, const VectorField& v, float factor, Field& f, const ExecutionContext& context);
/// f = factor * G P v: the divergence on a grid of what lives on the next coarser one.
void divergenceOfCoarse(const BlockGrid& coarseGrid, const VectorField& v, const BlockGrid& fineGrid, float factor, Field& f,
                        const ExecutionContext& context);
/// fine = P coarse on every active fine block. All coarse blocks under them must be active.
void prolong(const BlockGrid& coarseGrid, const Field& coarse, const BlockGrid& fineGrid, Field& fine,
             const ExecutionContext& context);
/// coarse = factor * P^T fine; fine is 0 outside its active blocks.
void restrictTo(const BlockGrid& fineGrid, const Field& fine, const BlockGrid& coarseGrid, Field& coarse, float factor,
                const ExecutionContext& context);

}  // namespace glisson::poisson
