#include "viewer/orientation_cube.h"

#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace glisson {

OrientationCube::OrientationCube(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, double share) : share_(share) {
  cube_->SetXPlusFaceText("L");
  cube_->SetXMinusFaceText("R");
  cube_->SetYPlusFaceText("P");
  cube_->SetYMinusFaceText("A");
  cube_->SetZPlusFaceText("S");
  cube_->SetZMinusFaceText("I");
  cube_->SetFaceTextScale(0.6);
  cube_->SetXFaceTextRotation(0);
  cube_->SetYFaceTextRotation(0);
  cube_->SetZFaceTextRotation(90);  // upright with the patient's front up, as the superior view shows it
  cube_->GetCubeProperty()->SetColor(0.32, 0.34, 0.38);
  cube_->GetTextEdgesProperty()->SetColor(0.1, 0.1, 0.1);
  for (vtkProperty* face : {cube_->GetXPlusFaceProperty(), cube_->GetXMinusFaceProperty(), cube_->GetYPlusFaceProperty(),
                            cube_->GetYMinusFaceProperty(), cube_->GetZPlusFaceProperty(), cube_->GetZMinusFaceProperty()}) {
    face->SetColor(0.95, 0.95, 0.95);
    face->SetInterpolationToFlat();
  }
  marker_->SetOrientationMarker(cube_);
  marker_->SetInteractor(interactor);
  drawInTile(std::nullopt);
  marker_->SetDefaultRenderer(renderer);
  marker_->SetEnabled(1);
  marker_->InteractiveOff();
}

void OrientationCube::drawInTile(const std::optional<Tile>& tile) {
  const double height = (tile ? VtkWidget::kReportTiles : 1) * share_;
  marker_->SetViewport(0.0, 0.0, 0.8 * height, height);
  cube_->SetVisibility(!tile || (tile->x == 0 && tile->y == 0));
}

OrientationCube::~OrientationCube() {
  marker_->SetEnabled(0);
  marker_->SetInteractor(nullptr);
}

}  // namespace glisson
