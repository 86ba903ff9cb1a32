#include "tests/reconstruction/mcsd/plain_chain.h"

#include <gtest/gtest.h>
#include <vtkAlgorithmOutput.h>
#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkImageConstantPad.h>
#include <vtkImageData.h>
#include <vtkImageThreshold.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkSmoothPolyDataFilter.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <Eigen/Geometry>

namespace glisson::test {

/// A body without symmetry: a ball with an arm along each axis, of different lengths.
Mask asymmetricBody(const Index3& size) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                                   static_cast<std::size_t>(size[2]));
  std::size_t n = 0;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i, ++n) {
        const Vec3 p = Vec3(i, j, k) - Vec3(12, 11, 9);
        const bool ball = p.norm() < 6.3;
        const bool armI = p[0] > 0 && p[0] < 14 && std::abs(p[1]) < 3 && std::abs(p[2]) < 2;
        const bool armJ = p[1] < 0 && p[1] > -9 && std::abs(p[0]) < 2 && std::abs(p[2]) < 3;
        const bool armK = p[2] > 0 && p[2] < 11 && std::abs(p[0] - 1) < 3 && std::abs(p[1]) < 3;
        values[n] = ball || armI || armJ || armK ? 1 : 0;
      }
    }
  }
  return Mask::fromGrid(size, values);
}

ImageGeometry obliqueGeometry(const Index3& size, bool leftHanded) {
  ImageGeometry geometry;
  geometry.size = size;
  geometry.spacing = Vec3(0.57, 0.71, 1.6);
  geometry.origin = Vec3(-110.25, 43.5, -712.75);
  geometry.direction =
      (Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-1.1, Vec3::UnitY())).toRotationMatrix();
  if (leftHanded) {
    geometry.direction.col(2) *= -1;
  }
  return geometry;
}

/// The reference chain, written plainly on the whole grid (method.md 3; inside 201: see mcsd.h).
SurfaceMesh plainChain(const Mask& mask, const ImageGeometry& geometry, const McsdParameters& p, bool consistency) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(geometry.size.data());
  image->AllocateScalars(VTK_SHORT, 1);
  for (int k = 0; k < geometry.size[2]; ++k) {
    for (int j = 0; j < geometry.size[1]; ++j) {
      for (int i = 0; i < geometry.size[0]; ++i) {
        image->SetScalarComponentFromDouble(i, j, k, 0, mask.at(i, j, k) ? 7 : 0);
      }
    }
  }
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputData(image);
  pad->SetConstant(0);
  pad->SetOutputWholeExtent(-1, geometry.size[0], -1, geometry.size[1], -1, geometry.size[2]);
  vtkNew<vtkImageThreshold> threshold;
  threshold->SetInputConnection(pad->GetOutputPort());
  threshold->ThresholdBetween(7, 7);
  threshold->SetInValue(201);
  threshold->SetOutValue(0);
  vtkNew<vtkMarchingCubes> cubes;
  cubes->SetInputConnection(threshold->GetOutputPort());
  cubes->SetValue(0, 100.5);
  cubes->ComputeScalarsOff();
  cubes->ComputeGradientsOff();
  cubes->ComputeNormalsOff();
  vtkAlgorithmOutput* last = cubes->GetOutputPort();
  vtkNew<vtkDecimatePro> decimate;
  decimate->SetFeatureAngle(60);
  decimate->SplittingOff();
  decimate->PreserveTopologyOn();
  decimate->SetMaximumError(1);
  decimate->SetTargetReduction(p.decimation);
  const auto addDecimation = [&] {
    if (p.decimation > 0) {
      decimate->SetInputConnection(last);
      last = decimate->GetOutputPort();
    }
  };
  if (p.order == McsdOrder::DecimateFirst) {
    addDecimation();
  }
  vtkNew<vtkReverseSense> reverse;
  if (geometry.leftHanded()) {
    reverse->SetInputConnection(last);
    last = reverse->GetOutputPort();
  }
  vtkNew<vtkSmoothPolyDataFilter> laplacian;
  vtkNew<vtkWindowedSincPolyDataFilter> sinc;
  if (p.smoothing > 0 && p.filter == SmoothingFilter::Laplacian) {
    laplacian->SetInputConnection(last);
    laplacian->SetRelaxationFactor(0.33);
    laplacian->SetFeatureAngle(60);
    laplacian->SetConvergence(0);
    laplacian->SetNumberOfIterations(p.smoothing);
    laplacian->FeatureEdgeSmoothingOff();
    laplacian->BoundarySmoothingOff();
    last = laplacian->GetOutputPort();
  } else if (p.smoothing > 0) {
    sinc->SetInputConnection(last);
    sinc->SetPassBand(0.1);
    sinc->SetNumberOfIterations(p.smoothing);
    sinc->FeatureEdgeSmoothingOff();
    sinc->BoundarySmoothingOff();
    last = sinc->GetOutputPort();
  }
  if (p.order == McsdOrder::SmoothFirst) {
    addDecimation();
  }
  last->GetProducer()->Update();
  auto* index = vtkPolyData::SafeDownCast(last->GetProducer()->GetOutputDataObject(0));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType n = 0; n < index->GetNumberOfPoints(); ++n) {
    const Vec3 world = geometry.toWorld(Vec3(index->GetPoint(n)));
    points->InsertNextPoint(world.data());
  }
  vtkNew<vtkPolyData> inWorld;
  inWorld->ShallowCopy(index);
  inWorld->SetPoints(points);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(inWorld);
  normals->SetFeatureAngle(60);
  normals->SetSplitting(p.splitNormals ? 1 : 0);
  normals->SetConsistency(consistency ? 1 : 0);
  normals->Update();
  vtkPolyData* surface = normals->GetOutput();
  SurfaceMesh mesh;
  for (vtkIdType n = 0; n < surface->GetNumberOfCells(); ++n) {
    vtkNew<vtkIdList> corners;
    surface->GetCellPoints(n, corners);
    Triangle t{};
    for (std::size_t c = 0; c < 3; ++c) {
      t[c] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.emplace_back(surface->GetPoint(corners->GetId(static_cast<vtkIdType>(c))));
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

void expectSameTriangles(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  double worst = 0;
  for (std::size_t n = 0; n < a.triangles.size(); ++n) {
    for (std::size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, (a.vertices[a.triangles[n][c]] - b.vertices[b.triangles[n][c]]).norm());
    }
  }
  EXPECT_EQ(worst, 0.0);
}

}  // namespace glisson::test
