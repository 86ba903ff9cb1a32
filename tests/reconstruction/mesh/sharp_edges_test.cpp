// Meshes taken apart at sharp edges: solids whose copies can be counted, and what VTK makes of the same mesh.

#include "reconstruction/mesh/sharp_edges.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>

#include "reconstruction/mcsd/mcsd.h"
#include "tests/reconstruction/mesh/solids.h"

namespace glisson {
namespace {

std::array<Vec3, 3> cornersOf(const SurfaceMesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

void expectEqualTriangles(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t n = 0; n < a.triangles.size(); ++n) {
    ASSERT_EQ(cornersOf(a, a.triangles[n]), cornersOf(b, b.triangles[n])) << n;
  }
}

TEST(SharpEdges, OfABoxGiveEachFaceItsOwnVertices) {
  const SurfaceMesh box = test::box(Vec3(1, 2, 3), Vec3(4, 5, 6), 3);
  const SurfaceMesh split = splitAtSharpEdges(box);
  EXPECT_EQ(split.vertices.size(), 6U * 16U);
  expectEqualTriangles(split, box);
  EXPECT_EQ(splitAtSharpEdges(box, 91).vertices.size(), box.vertices.size());
}

TEST(SharpEdges, PartTheTrianglesAtAVertexIntoThoseBetweenThem) {
  // Two flat triangles and two that rise by 45 degrees around (0, 0, 0).
  const SurfaceMesh crease{{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}};
  const auto copies = [&](const SurfaceMesh& mesh, const Vec3& at) {
    return std::count(mesh.vertices.begin(), mesh.vertices.end(), at);
  };
  const SurfaceMesh split = splitAtSharpEdges(crease, 30);
  EXPECT_EQ(copies(split, {0, 0, 0}), 2);
  EXPECT_EQ(copies(split, {1, 0, 1}), 1);
  EXPECT_EQ(copies(split, {0, 1, 0}), 2);
  expectEqualTriangles(split, crease);
  EXPECT_EQ(splitAtSharpEdges(crease, 50).vertices.size(), crease.vertices.size());
}

TEST(SharpEdges, AreThoseOfVtk) {
  // Uneven spacing, so that no angle is 60 degrees to the last bit.
  ImageGeometry geometry;
  geometry.size = {14, 13, 12};
  geometry.spacing = Vec3(0.57, 0.71, 1.6);
  std::vector<std::uint8_t> values;
  for (int n = 0; n < 14 * 13 * 12; ++n) {
    const int slice = n / (14 * 13);
    const Vec3 at = Vec3(n % 14, n / 14 % 13, slice) - Vec3(6.4, 6.1, 5.3);
    values.push_back(at.norm() < 4.6 || (std::abs(at[0]) < 2 && std::abs(at[1]) < 5.5) ? 1 : 0);
  }
  for (const double decimation : {0.0, 0.5}) {
    const SurfaceMesh mesh =
        reconstructMcsd(Mask::fromGrid(geometry.size, values), geometry, {.smoothing = 0, .decimation = decimation}).mesh;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& vertex : mesh.vertices) {
      points->InsertNextPoint(vertex.data());
    }
    vtkNew<vtkCellArray> cells;
    for (const Triangle& t : mesh.triangles) {
      cells->InsertNextCell({t[0], t[1], t[2]});
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(data);
    normals->SetFeatureAngle(kFeatureAngleDegrees);
    normals->SplittingOn();
    normals->ConsistencyOff();
    normals->Update();
    const SurfaceMesh split = splitAtSharpEdges(mesh);
    EXPECT_GT(split.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(split.vertices.size(), static_cast<std::size_t>(normals->GetOutput()->GetNumberOfPoints())) << decimation;
    expectEqualTriangles(split, mesh);
  }
}

}  // namespace
}  // namespace glisson
