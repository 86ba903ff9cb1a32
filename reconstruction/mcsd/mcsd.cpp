#include "reconstruction/mcsd/mcsd.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkSmartPointer.h>
#include <vtkSmoothPolyDataFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <chrono>

#include "reconstruction/errors.h"
#include "reconstruction/mesh/edges.h"
#include "reconstruction/text.h"

namespace glisson {

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

vtkSmartPointer<vtkPolyData> run(vtkPolyDataAlgorithm& filter, const ExecutionContext& context, const char* phase) {
  context.report(0.0, phase);
  Watch watch{context, phase};
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(&Watch::onProgress);
  command->SetClientData(&watch);
  filter.AddObserver(vtkCommand::ProgressEvent, command);
  filter.Update();
  filter.RemoveObserver(command);
  context.throwIfCancelled();
  vtkSmartPointer<vtkPolyData> output = filter.GetOutput();
  return output;
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

vtkSmartPointer<vtkPolyData> decimated(vtkPolyData* surface, double share, const ExecutionContext& context) {
  vtkNew<vtkDecimatePro> decimate;
  decimate->SetInputData(surface);
  decimate->SetFeatureAngle(60);
  decimate->SplittingOff();
  decimate->PreserveTopologyOn();
  decimate->SetMaximumError(1);
  decimate->SetTargetReduction(share);
  return run(*decimate, context, "decimation");
}

vtkSmartPointer<vtkPolyData> smoothed(vtkPolyData* surface, const McsdParameters& parameters, const ExecutionContext& context) {
  if (parameters.filter == SmoothingFilter::Laplacian) {
    vtkNew<vtkSmoothPolyDataFilter> laplacian;
    laplacian->SetInputData(surface);
    laplacian->SetRelaxationFactor(0.33);
    laplacian->SetFeatureAngle(60);
    laplacian->SetConvergence(0);
    laplacian->SetNumberOfIterations(parameters.smoothing);
    laplacian->FeatureEdgeSmoothingOff();
    laplacian->BoundarySmoothingOff();
    return run(*laplacian, context, "smoothing");
  }
  vtkNew<vtkWindowedSincPolyDataFilter> sinc;
  sinc->SetInputData(surface);
  sinc->SetPassBand(0.1);
  sinc->SetNumberOfIterations(parameters.smoothing);
  sinc->FeatureEdgeSmoothingOff();
  sinc->BoundarySmoothingOff();
  return run(*sinc, context, "smoothing");
}

SurfaceMesh toWorld(vtkPolyData* surface, const ImageGeometry& geometry) {
  SurfaceMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    Vec3 index;
    surface->GetPoint(static_cast<vtkIdType>(n), index.data());
    mesh.vertices[n] = geometry.toWorld(index);
  }
  mesh.triangles.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  vtkNew<vtkIdList> corners;
  vtkCellArray* polys = surface->GetPolys();
  for (vtkIdType n = 0; n < polys->GetNumberOfCells(); ++n) {
    polys->GetCellAtId(n, corners);
    if (corners->GetNumberOfIds() == 3) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(corners->GetId(0)), static_cast<std::uint32_t>(corners->GetId(1)),
                                static_cast<std::uint32_t>(corners->GetId(2))});
    }
  }
  dropUnusedVertices(mesh);
  return mesh;
}

/// Runs `step`, adding its time to `seconds`.
template <typename Step>
auto timed(double& seconds, Step&& step) {
  const auto start = std::chrono::steady_clock::now();
  auto result = step();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}
}  // namespace

void McsdParameters::validate() const {
  if (smoothing < 0 || smoothing > 1000) {
    throw UsageError("The number of smoothing iterations is " + std::to_string(smoothing) + "; choose 0 to 1000.");
  }
  if (smoothing == 1 && filter == SmoothingFilter::Sinc) {
    throw UsageError("One iteration of the windowed sinc filter collapses the surface; choose 0, or 2 to 1000.");
  }
  if (!(decimation >= 0.0 && decimation <= 0.99)) {
    throw UsageError("The decimation is " + formatExact(decimation) + "; choose a share from 0 to 0.99.");
  }
}

McsdResult reconstructMcsd(const Mask& mask, const ImageGeometry& geometry, const McsdParameters& parameters,
                           const ExecutionContext& context) {
  parameters.validate();
  if (mask.empty()) {
    throw ReconstructionError("The mask is empty, so there is no surface to make; choose another structure.");
  }
  McsdResult result;
  vtkSmartPointer<vtkPolyData> surface = timed(result.extractSeconds, [&] {
    vtkNew<vtkMarchingCubes> cubes;
    cubes->SetInputData(paddedImage(mask));
    cubes->SetValue(0, kIso);
    cubes->ComputeScalarsOff();
    cubes->ComputeGradientsOff();
    cubes->ComputeNormalsOff();
    return run(*cubes, context.range(0.0, 0.3), "marching cubes");
  });
  const auto decimate = [&](const ExecutionContext& part) {
    if (parameters.decimation > 0) {
      surface = timed(result.decimateSeconds, [&] { return decimated(surface, parameters.decimation, part); });
    }
  };
  const auto smooth = [&](const ExecutionContext& part) {
    if (parameters.smoothing > 0) {
      surface = timed(result.smoothSeconds, [&] { return smoothed(surface, parameters, part); });
    }
  };
  const auto orient = [&] {
    if (geometry.leftHanded()) {
      vtkNew<vtkReverseSense> reverse;
      reverse->SetInputData(surface);
      surface = run(*reverse, context.range(0.3, 0.3), "orientation");
    }
  };
  if (parameters.order == McsdOrder::DecimateFirst) {
    decimate(context.range(0.3, 0.6));
    orient();
    smooth(context.range(0.6, 0.9));
  } else {
    orient();
    smooth(context.range(0.3, 0.6));
    decimate(context.range(0.6, 0.9));
  }
  // Without splitting the filter only adds normals, which a SurfaceMesh does not carry.
  if (parameters.splitNormals) {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface);
    normals->SetFeatureAngle(60);
    normals->SplittingOn();
    surface = run(*normals, context.range(0.9, 0.98), "normals");
  }
  result.mesh = toWorld(surface, geometry);
  context.report(1.0, "marching cubes, smoothing, decimation");
  return result;
}

}  // namespace glisson
