#include "planning/territories/tumour_territories.h"

#include <algorithm>
#include <tuple>

#include "planning/case/structure_mask.h"

namespace glisson {

namespace {
/// Voxels in both; the runs of each are in order.
std::size_t commonVoxels(const VoxelRows& a, const VoxelRows& b) {
  const auto row = [](const RowRun& run) { return std::tie(run.k, run.j); };
  std::size_t common = 0;
  auto x = a.runs.begin();
  auto y = b.runs.begin();
  while (x != a.runs.end() && y != b.runs.end()) {
    if (row(*x) != row(*y)) {
      ++(row(*x) < row(*y) ? x : y);
      continue;
    }
    const int endX = x->i + x->n;
    const int endY = y->i + y->n;
    common += static_cast<std::size_t>(std::max(0, std::min(endX, endY) - std::max(x->i, y->i)));
    ++(endX < endY ? x : y);
  }
  return common;
}
}  // namespace

std::vector<TumourTerritories> tumourTerritories(const Case& source, const Territories& territories) {
  std::vector<TumourTerritories> all;
  if (territories.parts.empty()) {
    return all;
  }
  const double voxelMl = territories.geometry.voxelVolumeMm3() * kMlPerMm3;
  for (const Structure& structure : source.model->structures) {
    if (!isLesion(structure.kind)) {
      continue;
    }
    const VoxelRows rows = rowsOf(maskOf(source, structure));
    TumourTerritories tumour{structure.id, structure.name, {}};
    for (const Territory& part : territories.parts) {
      if (const std::size_t voxels = commonVoxels(rows, part.rows); voxels > 0) {
        const double percent = 100.0 * static_cast<double>(voxels) / static_cast<double>(rows.voxels);
        tumour.shares.push_back({part.name, static_cast<double>(voxels) * voxelMl, percent});
      }
    }
    std::ranges::stable_sort(tumour.shares, std::ranges::greater(), &TerritoryShare::volumeMl);
    all.push_back(std::move(tumour));
  }
  return all;
}

}  // namespace glisson
