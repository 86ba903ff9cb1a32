#include "viewer/mesh_polydata.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <Eigen/Geometry>
#include <span>

#include "reconstruction/mesh/vertex_normals.h"
#include "reconstruction/parallel.h"
#include "viewer/clustering.h"

namespace glisson {

namespace {

/// Per structure; software OpenGL draws a whole model of such within 100 ms a frame.
constexpr std::size_t kCoarseTriangles = 6000;
/// Per structure; of a view at rest where the whole mesh takes too long (software OpenGL).
constexpr std::size_t kReducedTriangles = 8000;

}  // namespace

vtkSmartPointer<vtkPolyData> toPolyData(const SurfaceMesh& mesh) {
  const auto vertexCount = static_cast<vtkIdType>(mesh.vertices.size());
  const auto triangleCount = static_cast<vtkIdType>(mesh.triangles.size());
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(vertexCount);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(vertexCount);
  const std::vector<Vec3> normal = vertexNormals(mesh);
  float* toPoint = coordinates->GetPointer(0);
  float* toNormal = normals->GetPointer(0);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      *toPoint++ = static_cast<float>(mesh.vertices[v][c]);
      *toNormal++ = static_cast<float>(normal[v][c]);
    }
  }

  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(triangleCount + 1);
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * triangleCount);
  vtkTypeInt32* toCorner = corners->GetPointer(0);
  for (vtkIdType t = 0; t <= triangleCount; ++t) {
    offsets->SetValue(t, static_cast<vtkTypeInt32>(3 * t));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      *toCorner++ = static_cast<vtkTypeInt32>(corner);
    }
  }

  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  auto poly = vtkSmartPointer<vtkPolyData>::New();
  poly->SetPoints(points);
  poly->SetPolys(cells);
  poly->GetPointData()->SetNormals(normals);
  return poly;
}

namespace {

/// Leaves null what is the surface itself.
void makeDetail(DisplayMesh& made, Detail detail) {
  const SurfaceMesh& mesh = made.source->mesh;
  const std::size_t triangles = mesh.triangles.size();
  vtkSmartPointer<vtkPolyData>& poly = made.polys[static_cast<std::size_t>(detail)];
  if (detail == Detail::Full) {
    poly = toPolyData(mesh);
  } else if (detail == Detail::Coarse) {
    made.coarse = clustered(mesh, kCoarseTriangles);
    poly = triangles > kCoarseTriangles ? toPolyData(made.coarse) : nullptr;
  } else if (triangles > kReducedTriangles) {
    poly = toPolyData(clustered(mesh, kReducedTriangles));
  }
}

void makeDetails(DisplayMesh& made, std::span<const Detail> details) {
  parallelFor(details.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      makeDetail(made, details[n]);
    }
  });
  for (vtkSmartPointer<vtkPolyData>& poly : made.polys) {
    poly = poly != nullptr ? poly : made.polys[static_cast<std::size_t>(Detail::Full)];
    poly->ComputeBounds();  // else the first frame computes and keeps them
  }
}

}  // namespace

std::shared_ptr<const DisplayMesh> makeDisplayMesh(std::shared_ptr<const Reconstruction> reconstruction) {
  auto made = std::make_shared<DisplayMesh>();
  made->source = std::move(reconstruction);
  makeDetails(*made, std::array{Detail::Coarse, Detail::Reduced, Detail::Full});
  return made;
}

std::shared_ptr<const DisplayMesh> makeBareDisplayMesh(std::shared_ptr<const Reconstruction> reconstruction) {
  auto made = std::make_shared<DisplayMesh>();
  made->source = std::move(reconstruction);
  makeDetails(*made, std::array{Detail::Full});
  return made;
}

std::shared_ptr<const DisplayMesh> withStandIns(const DisplayMesh& bare) {
  auto made = std::make_shared<DisplayMesh>();
  made->source = bare.source;
  made->polys[static_cast<std::size_t>(Detail::Full)] = bare.poly(Detail::Full);
  makeDetails(*made, std::array{Detail::Coarse, Detail::Reduced});
  return made;
}

const Reconstruction& sourceOf(const DisplayMesh& mesh) { return *mesh.source; }

}  // namespace glisson
