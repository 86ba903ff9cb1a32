#include "viewer/measure_actors.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <QLocale>

namespace glisson {

namespace {

struct Drawn {
  vtkNew<vtkLineSource> line;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkBillboardTextActor3D> label;
};

std::unique_ptr<Drawn> draw(const Measure& measure) {
  auto drawn = std::make_unique<Drawn>();
  drawn->line->SetPoint1(measure.from.x(), measure.from.y(), measure.from.z());
  drawn->line->SetPoint2(measure.to.x(), measure.to.y(), measure.to.z());
  drawn->mapper->SetInputConnection(drawn->line->GetOutputPort());
  drawn->actor->SetMapper(drawn->mapper);
  drawn->actor->GetProperty()->SetColor(0.6, 1.0, 1.0);
  drawn->actor->GetProperty()->SetLineWidth(2);
  drawn->actor->GetProperty()->LightingOff();
  const Vec3 middle = 0.5 * (measure.from + measure.to);
  drawn->label->SetPosition(middle.x(), middle.y(), middle.z());
  drawn->label->SetInput((QLocale().toString(measure.mm(), 'f', 1) + QStringLiteral(" mm")).toUtf8().constData());
  vtkTextProperty* text = drawn->label->GetTextProperty();
  text->SetFontSize(12);
  text->SetColor(0.6, 1.0, 1.0);
  text->SetBackgroundColor(0.1, 0.11, 0.13);
  text->SetBackgroundOpacity(0.75);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToBottom();
  return drawn;
}

}  // namespace

struct MeasureActors::Impl {
  vtkRenderer* overlay = nullptr;
  std::vector<Measure> measures;
  std::vector<std::unique_ptr<Drawn>> drawn;

  void clear() {
    for (const auto& each : drawn) {
      overlay->RemoveActor(each->actor);
      overlay->RemoveViewProp(each->label);
    }
    drawn.clear();
  }
};

MeasureActors::MeasureActors(vtkRenderer* overlay) : impl_(std::make_unique<Impl>()) { impl_->overlay = overlay; }

MeasureActors::~MeasureActors() { impl_->clear(); }

void MeasureActors::setMeasures(const std::vector<Measure>& measures) {
  Impl& d = *impl_;
  if (measures == d.measures) {
    return;
  }
  d.clear();
  d.measures = measures;
  for (const Measure& measure : measures) {
    d.drawn.push_back(draw(measure));
    d.overlay->AddActor(d.drawn.back()->actor);
    d.overlay->AddViewProp(d.drawn.back()->label);
  }
}

}  // namespace glisson
