#include "viewer/surface_actor.h"

#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

#include <algorithm>

namespace glisson {

namespace {

vtkSmartPointer<vtkFloatArray> arrayOf(const std::vector<double>& values) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("error");
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::ranges::transform(values, array->GetPointer(0), [](double value) { return static_cast<float>(value); });
  return array;
}

std::vector<Vec3> pointsOf(vtkPolyData* poly) {
  std::vector<Vec3> points(static_cast<std::size_t>(poly->GetNumberOfPoints()));
  for (std::size_t n = 0; n < points.size(); ++n) {
    poly->GetPoint(static_cast<vtkIdType>(n), points[n].data());
  }
  return points;
}

}  // namespace

std::shared_ptr<const SurfaceErrors> makeSurfaceErrors(const DisplayMesh& mesh, const ValuesAt& valuesAt) {
  auto errors = std::make_shared<SurfaceErrors>();
  for (std::size_t d = kDetails; d-- > 0;) {  // the finest first
    for (std::size_t finer = d + 1; finer < kDetails && errors->values[d] == nullptr; ++finer) {
      if (mesh.polys[finer] == mesh.polys[d]) {
        errors->values[d] = errors->values[finer];
      }
    }
    if (errors->values[d] == nullptr) {
      errors->values[d] = arrayOf(d + 1 == kDetails ? valuesAt(mesh.source->mesh.vertices) : valuesAt(pointsOf(mesh.polys[d])));
    }
  }
  return errors;
}

SurfaceActor::SurfaceActor(vtkRenderer* renderer, std::shared_ptr<const DisplayMesh> mesh)
    : renderer_(renderer), mesh_(std::move(mesh)) {
  vtkProperty* look = actor_->GetProperty();
  look->SetColor(0.78, 0.74, 0.7);
  look->SetInterpolationToPhong();
  look->SetAmbient(0.25);
  look->SetDiffuse(0.8);
  look->SetSpecular(0.1);
  look->SetSpecularPower(20);
  setErrors(nullptr, nullptr);
  setDetail(Detail::Coarse);
  uploaded_ = {};
  renderer_->AddActor(actor_);
}

SurfaceActor::~SurfaceActor() { renderer_->RemoveActor(actor_); }

void SurfaceActor::setErrors(const std::shared_ptr<const SurfaceErrors>& errors, vtkLookupTable* colours) {
  errors_ = errors;
  for (std::size_t d = 0; d < kDetails; ++d) {
    if (errors == nullptr) {
      mappers_[d]->SetInputData(mesh_->polys[d]);
      mappers_[d]->ScalarVisibilityOff();
      continue;
    }
    // The mesh is shared with other views: only the values are this one's.
    vtkNew<vtkPolyData> coloured;
    coloured->ShallowCopy(mesh_->polys[d]);
    coloured->GetPointData()->SetScalars(errors->values[d]);
    mappers_[d]->SetInputData(coloured);
    mappers_[d]->SetLookupTable(colours);
    mappers_[d]->SetScalarModeToUsePointData();
    mappers_[d]->SetInterpolateScalarsBeforeMapping(true);
    mappers_[d]->UseLookupTableScalarRangeOn();
    mappers_[d]->ScalarVisibilityOn();
  }
}

void SurfaceActor::setWireframe(bool wireframe) {
  if (wireframe) {
    actor_->GetProperty()->SetRepresentationToWireframe();
  } else {
    actor_->GetProperty()->SetRepresentationToSurface();
  }
}

void SurfaceActor::setClip(vtkPlane* plane) {
  for (const vtkNew<vtkPolyDataMapper>& mapper : mappers_) {
    mapper->RemoveAllClippingPlanes();
    if (plane != nullptr) {
      mapper->AddClippingPlane(plane);
    }
  }
}

void SurfaceActor::setDetail(Detail detail) {
  const auto d = static_cast<std::size_t>(detail);
  actor_->SetMapper(mappers_[d]);
  uploaded_[d] = true;
}

std::size_t SurfaceActor::triangles(Detail detail) const {
  return static_cast<std::size_t>(mesh_->poly(detail)->GetNumberOfPolys());
}

}  // namespace glisson
