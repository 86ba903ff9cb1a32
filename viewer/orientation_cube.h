#pragma once
// Purpose: the cube with L R P A S I in the corner of a 3D view, turning with its camera. Private to viewer/.

#include <vtkAnnotatedCubeActor.h>
#include <vtkNew.h>
#include <vtkOrientationMarkerWidget.h>

#include <optional>

#include "viewer/vtk_scene.h"

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace glisson {

class OrientationCube {
 public:
  /// `share` of the view's height, a little less of its width.
  OrientationCube(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, double share = 0.2);
  /// To be destroyed while the view's context is current.
  ~OrientationCube();
  OrientationCube(const OrientationCube&) = delete;
  OrientationCube& operator=(const OrientationCube&) = delete;

  /// For one of the tiles of a larger picture, where the cube has its share of the picture and lies within the lowest left tile.
  void drawInTile(const std::optional<Tile>& tile);

 private:
  double share_;
  vtkNew<vtkAnnotatedCubeActor> cube_;
  vtkNew<vtkOrientationMarkerWidget> marker_;
};

}  // namespace glisson
