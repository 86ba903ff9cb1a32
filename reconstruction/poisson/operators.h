#pragma once
// Purpose: the finite-element operators between and on nested grids of trilinear B-splines phi. On a level with cell h:
//   S   stiffness over h:    S_ij = 1/h int grad phi_i . grad phi_j = K x M x M + M x K x M + M x M x K, K = [-1 2 -1], M = [1 4
//   1]/6 G   divergence over h^2: (G V)_i = 1/h^2 int V . grad phi_i = sum over axes of D x M x M V_a, D = [1 0 -1]/2 P
//   prolongation: the coarse function on the fine grid, [1/2 1 1/2] per axis; P^T its transpose
// laplace X = div V in weak form is S X = f with f = h G V (V a density, 1/mm; h in mm). Nested: S_coarse = P^T S P / 2 and
// f_coarse = P^T f / 2.

#include "reconstruction/execution_context.h"
#include "reconstruction/poisson/block_grid.h"

namespace glisson::poisson {

/// out = S u on the unknowns, 0 on fixed nodes.
void applyStiffness(const BlockGrid& grid, const Field& u, Field& out, const ExecutionContext& context);
/// out += factor * (D x M x M along axis 0, 1 or 2) v.
void addDivergence(const BlockGrid& grid, const Field& v, int axis, float factor, Field& out, const ExecutionContext& context);
/// fine = P coarse on every active fine block from `firstSlot` on. All coarse blocks under them must be active.
void prolong(const BlockGrid& coarseGrid, const Field& coarse, const BlockGrid& fineGrid, Field& fine, std::size_t firstSlot,
             const ExecutionContext& context);
/// coarse = factor * P^T fine; fine is 0 outside its active blocks.
void restrictTo(const BlockGrid& fineGrid, const Field& fine, const BlockGrid& coarseGrid, Field& coarse, float factor,
                const ExecutionContext& context);

}  // namespace glisson::poisson
