#pragma once
// Purpose: counts what a plan of flat planes takes of one run of voxels after the other (resected.h says how). Frame: image, mm.

#include <cstdint>
#include <optional>
#include <vector>

#include "planning/volumetry/resected.h"

namespace glisson {

enum class RunSide : std::uint8_t { Outside, Across, Inside };

/// `distance`: of a box's centre to a plane, `support`: half the box's extent along its normal, mm. A box that only touches the
/// plane from outside is Across: the shared face is its section.
inline RunSide sideOf(double distance, double support) {
  if (distance < -support - kOnPlaneMm) {
    return RunSide::Outside;
  }
  return distance < support - kOnPlaneMm ? RunSide::Across : RunSide::Inside;
}
inline RunSide sideOf(const Box& box, const ImagePlane& plane) {
  return sideOf(plane.distance(box.centre), plane.support(box.half));
}

/// What decides alone on a run: one plane of one resection.
struct OnlyPlane {
  const ImagePlane* plane = nullptr;
  std::size_t resection = 0;
};

class RunCounter {
 public:
  /// `plan` has no bends. All three outlive this.
  RunCounter(const Vec3& spacing, const std::vector<ImageResection>& plan, Resected& result);

  /// Adds the run's units to the result, per resection.
  void count(const RowRun& run);
  /// Adds `voxels` voxels of a box whole to what has all of it, where no plane divides it; false where one does.
  bool countUndivided(const Box& box, std::size_t voxels);
  /// The section's area, where the plan is one plane: every run it cuts was counted in closed form.
  [[nodiscard]] double singlePlaneArea() const { return singlePlaneArea_; }

  /// Whether the run is on one side altogether, and on which.
  [[nodiscard]] RunSide sideOfRun(const RowRun& run) const { return sideOfBox(boxOf(run, spacing_)); }
  [[nodiscard]] RunSide sideOfBox(const Box& box) const;
  /// The plane that cuts the run where nothing but this plane decides what is taken of it; none elsewhere.
  [[nodiscard]] OnlyPlane onlyPlaneAcross(const RowRun& run) const;

 private:
  /// Which resections have a part of a box.
  struct Reached {
    std::size_t resections = 0;  ///< none behind one that has all of it is looked at
    std::size_t first = 0;
    std::size_t planesAcross = 0;       ///< of the first one
    const ImagePlane* only = nullptr;   ///< the last of these
    std::optional<std::size_t> rest{};  ///< the second one, where it has all of the box: what the first leaves
  };
  [[nodiscard]] Reached reachedBy(const Box& box) const;
  /// A run that one plane cuts: the units on its side.
  [[nodiscard]] std::int64_t unitsAbove(const ImagePlane& plane, const RowRun& run, const Box& box);
  void countVoxel(const Box& box);

  const Vec3& spacing_;
  const std::vector<ImageResection>& plan_;
  Resected& result_;
  double singlePlaneArea_ = 0;
};

}  // namespace glisson
