#include "viewer/plane_actors.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextProperty.h>

#include <Eigen/Geometry>

#include "viewer/colour.h"

namespace glisson {

namespace {

constexpr Colour kHandle{0.95, 0.75, 0.25};
constexpr Colour kHighlight{1.0, 1.0, 0.85};
constexpr Colour kTooShort{1.0, 0.1, 0.1};
constexpr Colour kEnough{1.0, 1.0, 1.0};
constexpr Colour kControl{0.35, 0.85, 0.95};  ///< control points of a bend: told from the plane's own handles
constexpr double kTiltScale = 0.75;
constexpr double kControlScale = 0.6;

/// From a source's axes x, y, z to first, axes.u, axes.v, each `length` long, at `origin`.
vtkNew<vtkMatrix4x4> poseOf(double length, const Vec3& first, const PlaneAxes& axes, const Vec3& origin) {
  vtkNew<vtkMatrix4x4> pose;
  for (int row = 0; row < 3; ++row) {
    pose->SetElement(row, 0, length * first[row]);
    pose->SetElement(row, 1, length * axes.u[row]);
    pose->SetElement(row, 2, length * axes.v[row]);
    pose->SetElement(row, 3, origin[row]);
  }
  return pose;
}

void setColour(vtkActor* actor, const Colour& colour) { actor->GetProperty()->SetColor(colour.r, colour.g, colour.b); }

}  // namespace

struct PlaneActors::Impl {
  vtkRenderer* overlay = nullptr;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkPolyDataMapper> sphereMapper, arrowMapper;
  vtkNew<vtkActor> centreActor, arrowActor;
  std::array<vtkNew<vtkActor>, 4> tiltActors;
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkPolyDataMapper> cubeMapper;
  vtkNew<vtkActor> spinActor;
  vtkNew<vtkBillboardTextActor3D> label;
  vtkNew<vtkLineSource> line;
  vtkNew<vtkPolyDataMapper> lineMapper;
  vtkNew<vtkActor> lineActor;
  bool hasLine = false;
  std::array<vtkNew<vtkActor>, 16> controlActors;
  vtkNew<vtkPolyData> net;
  vtkNew<vtkPolyDataMapper> netMapper;
  vtkNew<vtkActor> netActor;

  [[nodiscard]] std::vector<vtkProp*> overlayProps() const {
    std::vector<vtkProp*> props{centreActor, arrowActor, spinActor, label};
    for (const auto& tilt : tiltActors) {
      props.push_back(tilt);
    }
    return props;
  }
};

PlaneActors::PlaneActors(vtkRenderer* overlay) : impl_(std::make_unique<Impl>()) {
  Impl& d = *impl_;
  d.overlay = overlay;

  d.lineMapper->SetInputConnection(d.line->GetOutputPort());
  d.lineActor->SetMapper(d.lineMapper);
  d.lineActor->GetProperty()->SetLineWidth(3);
  d.lineActor->GetProperty()->LightingOff();
  d.lineActor->SetVisibility(false);
  overlay->AddActor(d.lineActor);
  d.sphere->SetThetaResolution(24);
  d.sphere->SetPhiResolution(16);
  d.sphere->SetRadius(1);
  d.sphereMapper->SetInputConnection(d.sphere->GetOutputPort());
  d.arrow->SetShaftResolution(16);
  d.arrow->SetTipResolution(24);
  d.arrow->SetShaftRadius(0.025);
  d.arrow->SetTipRadius(0.09);
  d.arrow->SetTipLength(0.28);
  d.arrowMapper->SetInputConnection(d.arrow->GetOutputPort());
  d.centreActor->SetMapper(d.sphereMapper);
  d.arrowActor->SetMapper(d.arrowMapper);
  for (auto& tilt : d.tiltActors) {
    tilt->SetMapper(d.sphereMapper);
  }
  d.cubeMapper->SetInputConnection(d.cube->GetOutputPort());
  d.spinActor->SetMapper(d.cubeMapper);
  d.netMapper->SetInputData(d.net);
  d.netActor->SetMapper(d.netMapper);
  d.netActor->GetProperty()->LightingOff();
  setColour(d.netActor, kControl);
  d.netActor->GetProperty()->SetOpacity(0.6);
  d.netActor->SetVisibility(false);
  overlay->AddActor(d.netActor);
  for (auto& control : d.controlActors) {
    control->SetMapper(d.sphereMapper);
    control->SetVisibility(false);
    overlay->AddActor(control);
  }
  vtkTextProperty* text = d.label->GetTextProperty();
  text->SetFontSize(14);  // at 72 dpi; the render window's DPI follows the screen
  text->SetColor(1, 1, 1);
  text->SetBackgroundColor(0.1, 0.11, 0.13);
  text->SetBackgroundOpacity(0.75);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  for (vtkProp* prop : d.overlayProps()) {
    overlay->AddViewProp(prop);
  }
}

PlaneActors::~PlaneActors() {
  impl_->overlay->RemoveActor(impl_->lineActor);
  impl_->overlay->RemoveActor(impl_->netActor);
  for (const auto& control : impl_->controlActors) {
    impl_->overlay->RemoveActor(control);
  }
  for (vtkProp* prop : impl_->overlayProps()) {
    impl_->overlay->RemoveViewProp(prop);
  }
}

void PlaneActors::setVisible(bool visible) {
  for (vtkProp* prop : impl_->overlayProps()) {
    prop->SetVisibility(visible);
  }
  impl_->lineActor->SetVisibility(visible && impl_->hasLine);
}

void PlaneActors::placeHandles(const HalfSpace& plane, const HandleLayout& layout, std::optional<PlaneHandle> highlighted,
                               bool tilts) {
  Impl& d = *impl_;
  const auto colourOf = [&](PlaneHandle handle) { return highlighted == handle ? kHighlight : kHandle; };
  const double radius = kHandlePixels * layout.mmPerPixel;
  d.centreActor->SetPosition(layout.anchor.x(), layout.anchor.y(), layout.anchor.z());
  d.centreActor->SetScale(radius);
  setColour(d.centreActor, colourOf(PlaneHandle::Centre));
  for (std::size_t n = 0; n < 4; ++n) {
    const Vec3& at = layout.tilts[n];
    d.tiltActors[n]->SetPosition(at.x(), at.y(), at.z());
    d.tiltActors[n]->SetScale(kTiltScale * radius);
    d.tiltActors[n]->SetVisibility(tilts && layout.tiltShown[n]);
    setColour(d.tiltActors[n], colourOf(static_cast<PlaneHandle>(static_cast<int>(PlaneHandle::TiltRight) + static_cast<int>(n))));
  }

  const PlaneAxes axes = axesOf(plane.normal);
  // vtkArrowSource runs from (0,0,0) to (1,0,0).
  d.arrowActor->SetUserMatrix(poseOf(kArrowPixels * layout.mmPerPixel, plane.normal, axes, layout.anchor));
  const Vec3 outward = (layout.spin - layout.anchor).normalized();
  d.spinActor->SetUserMatrix(poseOf(1.4 * kTiltScale * radius, outward, {plane.normal, outward.cross(plane.normal)}, layout.spin));
  d.spinActor->SetVisibility(layout.spinShown);
  setColour(d.spinActor, colourOf(PlaneHandle::Spin));
  setColour(d.arrowActor, colourOf(PlaneHandle::Normal));
  d.label->SetPosition(layout.label.x(), layout.label.y(), layout.label.z());
}

void PlaneActors::placeControlPoints(const ResectionPlane* plane, const std::array<bool, 16>& highlighted, double mmPerPixel) {
  Impl& d = *impl_;
  d.netActor->SetVisibility(plane != nullptr);
  for (std::size_t n = 0; n < 16; ++n) {
    d.controlActors[n]->SetVisibility(plane != nullptr);
  }
  if (plane == nullptr) {
    return;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (std::size_t n = 0; n < 16; ++n) {
    const Vec3 at = controlPoint(*plane, n);
    points->InsertNextPoint(at.data());
    d.controlActors[n]->SetPosition(at.x(), at.y(), at.z());
    d.controlActors[n]->SetScale(kControlScale * kHandlePixels * mmPerPixel);
    setColour(d.controlActors[n], highlighted[n] ? kHighlight : kControl);
    const auto id = static_cast<vtkIdType>(n);
    if (n % 4 < 3) {
      lines->InsertNextCell({id, id + 1});
    }
    if (n / 4 < 3) {
      lines->InsertNextCell({id, id + 4});
    }
  }
  d.net->SetPoints(points);
  d.net->SetLines(lines);
  d.net->Modified();
}

void PlaneActors::setMarginLine(const std::optional<std::pair<Vec3, Vec3>>& line, bool tooShort) {
  Impl& d = *impl_;
  d.hasLine = line.has_value();
  d.lineActor->SetVisibility(d.hasLine && d.centreActor->GetVisibility() != 0);
  if (line) {
    d.line->SetPoint1(line->first.x(), line->first.y(), line->first.z());
    d.line->SetPoint2(line->second.x(), line->second.y(), line->second.z());
    setColour(d.lineActor, tooShort ? kTooShort : kEnough);
  }
}

void PlaneActors::setLabel(const std::string& text) { impl_->label->SetInput(text.c_str()); }

}  // namespace glisson
