#pragma once
// Purpose: the portal branches of each territory as tubes in its colour, with its name, in the overlay: nothing hides them. Frame:
// mm LPS.

#include <memory>
#include <vector>

#include "viewer/drawn_territory.h"

class vtkRenderer;

namespace glisson {

class TerritoryActors {
 public:
  explicit TerritoryActors(vtkRenderer* overlay);
  ~TerritoryActors();

  /// What is not among them any more goes. False: these are drawn already.
  bool setTerritories(std::vector<DrawnTerritory> territories);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson
