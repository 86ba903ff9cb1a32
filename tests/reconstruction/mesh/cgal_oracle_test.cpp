// Self-intersections against CGAL's exact search, pair by pair. CGAL is an oracle of the tests only: it is in no link line of ours.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "reconstruction/mesh/self_intersection.h"
#include "reconstruction/mesh/simplify.h"
#include "reconstruction/poisson/poisson.h"
#include "tests/reconstruction/mesh/solids.h"
#include "tests/support/trials.h"

namespace glisson {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Pairs = std::set<std::array<std::uint32_t, 2>>;

Pairs pairsByCgal(const SurfaceMesh& mesh) {
  CGAL::Surface_mesh<Kernel::Point_3> theirs;
  for (const Vec3& v : mesh.vertices) {
    theirs.add_vertex(Kernel::Point_3(v[0], v[1], v[2]));
  }
  using Vertex = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
  for (const Triangle& t : mesh.triangles) {
    EXPECT_NE(theirs.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])), theirs.null_face());
  }
  std::vector<std::pair<CGAL::Surface_mesh<Kernel::Point_3>::Face_index, CGAL::Surface_mesh<Kernel::Point_3>::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(theirs, std::back_inserter(found));
  Pairs pairs;
  for (const auto& [a, b] : found) {
    const auto one = static_cast<std::uint32_t>(a);
    const auto other = static_cast<std::uint32_t>(b);
    pairs.insert({std::min(one, other), std::max(one, other)});
  }
  return pairs;
}

Pairs ours(const SurfaceMesh& mesh) {
  const auto found = selfIntersections(mesh);
  return {found.begin(), found.end()};
}

TEST(CgalOracle, FindsTheSamePairsInCrumpledSpheres) {
  std::mt19937 random(7);
  std::size_t pairs = 0;
  for (int n = 0; n < test::trials(60); ++n) {
    SurfaceMesh mesh = test::sphere({0, 0, 0}, 10, 3);
    std::normal_distribution<double> push(0, 0.5 + 0.05 * (n % 12));
    for (Vec3& v : mesh.vertices) {
      v += Vec3(push(random), push(random), push(random));
    }
    const Pairs mine = ours(mesh);
    EXPECT_EQ(mine, pairsByCgal(mesh)) << n;
    pairs += mine.size();
  }
  EXPECT_GT(pairs, 20U);
}

TEST(CgalOracle, AgreesOnSurfacesOfNoiseAndSimplificationAddsNone) {
  std::mt19937 random(11);
  for (int n = 0; n < test::trials(40); ++n) {
    const Index3 size{20, 20, 16};
    std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    for (auto& value : values) {
      value = random() % 6 == 0 ? 1 : 0;  // touching voxels, single voxels, cavities
    }
    ImageGeometry geometry;
    geometry.size = size;
    geometry.spacing = Vec3(0.8, 0.8, 0.8 + 0.1 * n);
    const SurfaceMesh fine = reconstructPoisson(Mask::fromGrid(size, values), geometry, {.depth = 5 + n % 2}).mesh;
    const Pairs before = ours(fine);  // of noise, two loops of one cell may cross
    EXPECT_EQ(pairsByCgal(fine), before) << n;
    const SurfaceMesh coarse = simplify(fine, {.triangles = fine.triangles.size() / 4});
    EXPECT_EQ(pairsByCgal(coarse), ours(coarse)) << n;
    EXPECT_TRUE(!before.empty() || ours(coarse).empty()) << n;
  }
}

}  // namespace
}  // namespace glisson
