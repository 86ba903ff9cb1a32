#include "reconstruction/mcsd/mcsd_stages.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmoothPolyDataFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/edges.h"

namespace glisson::mcsd {

namespace {
constexpr double kIso = 100.5;
constexpr unsigned char kInside = 201;  // see mcsd.h: twice the iso value

/// Tells a filter's progress to a context, and stops the filter on cancel from its own thread (AbortExecute is a plain int).
struct Watch {
  ExecutionContext context;
  const char* phase;

  static void onProgress(vtkObject* caller, unsigned long /*event*/, void* client, void* /*data*/) {
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    const auto* watch = static_cast<const Watch*>(client);
    try {
      watch->context.report(filter->GetProgress(), watch->phase);
    } catch (const Cancelled&) {
      filter->SetAbortExecute(1);  // thrown again after Update(): no exception passes through VTK
    }
  }
};

/// The triangles of a filter's output; other cells would be none of ours.
IndexSurface surfaceOf(vtkPolyData& data) {
  IndexSurface surface;
  surface.points.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t n = 0; n < surface.points.size(); ++n) {
    Vec3 at;
    data.GetPoint(static_cast<vtkIdType>(n), at.data());
    surface.points[n] = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
  }
  vtkCellArray* polys = data.GetPolys();
  surface.triangles.reserve(static_cast<std::size_t>(polys->GetNumberOfCells()));
  for (vtkIdType n = 0; n < polys->GetNumberOfCells(); ++n) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    polys->GetCellAtId(n, count, corners);
    if (count == 3) {
      surface.triangles.push_back(
          {static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]), static_cast<std::uint32_t>(corners[2])});
    }
  }
  return surface;
}

vtkNew<vtkPolyData> dataOf(const IndexSurface& surface) {
  vtkNew<vtkPoints> points;  // single precision
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.points.size()));
  for (std::size_t n = 0; n < surface.points.size(); ++n) {
    points->SetPoint(static_cast<vtkIdType>(n), surface.points[n].data());
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(static_cast<vtkIdType>(surface.triangles.size()), static_cast<vtkIdType>(3 * surface.triangles.size()));
  for (const Triangle& t : surface.triangles) {
    polys->InsertNextCell({static_cast<vtkIdType>(t[0]), static_cast<vtkIdType>(t[1]), static_cast<vtkIdType>(t[2])});
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

IndexSurface run(vtkPolyDataAlgorithm& filter, const ExecutionContext& context, const char* phase) {
  context.report(0.0, phase);
  Watch watch{context, phase};
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(&Watch::onProgress);
  command->SetClientData(&watch);
  filter.AddObserver(vtkCommand::ProgressEvent, command);
  filter.Update();
  filter.RemoveObserver(command);
  context.throwIfCancelled();
  return surfaceOf(*filter.GetOutput());
}

/// The mask's box with one voxel of background around it, in the index frame of the whole grid.
vtkNew<vtkImageData> paddedImage(const Mask& mask) {
  const IndexBox& box = mask.box();
  vtkNew<vtkImageData> image;
  image->SetExtent(box.first[0] - 1, box.first[0] + box.size[0], box.first[1] - 1, box.first[1] + box.size[1], box.first[2] - 1,
                   box.first[2] + box.size[2]);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  const auto ni = static_cast<std::size_t>(box.size[0]) + 2;
  const auto nj = static_cast<std::size_t>(box.size[1]) + 2;
  std::fill_n(out, ni * nj * (static_cast<std::size_t>(box.size[2]) + 2), static_cast<unsigned char>(0));
  const std::uint8_t* in = mask.values().data();
  for (std::size_t k = 1; k <= static_cast<std::size_t>(box.size[2]); ++k) {
    for (std::size_t j = 1; j <= static_cast<std::size_t>(box.size[1]); ++j) {
      unsigned char* row = out + ni * (j + nj * k) + 1;
      for (std::size_t i = 0; i < static_cast<std::size_t>(box.size[0]); ++i) {
        row[i] = *in++ != 0 ? kInside : 0;
      }
    }
  }
  return image;
}
}  // namespace

IndexSurface extractSurface(const Mask& mask, const ExecutionContext& context) {
  vtkNew<vtkMarchingCubes> cubes;
  cubes->SetInputData(paddedImage(mask));
  cubes->SetValue(0, kIso);
  cubes->ComputeScalarsOff();
  cubes->ComputeGradientsOff();
  cubes->ComputeNormalsOff();
  return run(*cubes, context, "marching cubes");
}

IndexSurface decimate(const IndexSurface& surface, double share, const ExecutionContext& context) {
  vtkNew<vtkDecimatePro> decimate;
  decimate->SetInputData(dataOf(surface));
  decimate->SetFeatureAngle(60);
  decimate->SplittingOff();
  decimate->PreserveTopologyOn();
  decimate->SetMaximumError(1);
  decimate->SetTargetReduction(share);
  return run(*decimate, context, "decimation");
}

IndexSurface smooth(const IndexSurface& surface, SmoothingFilter filter, int iterations, const ExecutionContext& context) {
  if (filter == SmoothingFilter::Laplacian) {
    vtkNew<vtkSmoothPolyDataFilter> laplacian;
    laplacian->SetInputData(dataOf(surface));
    laplacian->SetRelaxationFactor(0.33);
    laplacian->SetFeatureAngle(60);
    laplacian->SetConvergence(0);
    laplacian->SetNumberOfIterations(iterations);
    laplacian->FeatureEdgeSmoothingOff();
    laplacian->BoundarySmoothingOff();
    return run(*laplacian, context, "smoothing");
  }
  vtkNew<vtkWindowedSincPolyDataFilter> sinc;
  sinc->SetInputData(dataOf(surface));
  sinc->SetPassBand(0.1);
  sinc->SetNumberOfIterations(iterations);
  sinc->FeatureEdgeSmoothingOff();
  sinc->BoundarySmoothingOff();
  return run(*sinc, context, "smoothing");
}

IndexSurface reversed(IndexSurface surface) {
  for (Triangle& t : surface.triangles) {
    std::swap(t[0], t[2]);
  }
  return surface;
}

bool everyEdgeHasTwoTriangles(const IndexSurface& surface) {
  bool two = true;
  MeshEdges(surface.points.size(), surface.triangles).forEachEdge([&](auto sides) { two = two && sides.size() == 2; });
  return two;
}

SurfaceMesh toWorld(const IndexSurface& surface, const ImageGeometry& geometry) {
  SurfaceMesh mesh;
  mesh.vertices.reserve(surface.points.size());
  for (const auto& p : surface.points) {
    mesh.vertices.push_back(geometry.toWorld(Vec3(p[0], p[1], p[2])));
  }
  mesh.triangles = surface.triangles;
  dropUnusedVertices(mesh);
  return mesh;
}

}  // namespace glisson::mcsd
