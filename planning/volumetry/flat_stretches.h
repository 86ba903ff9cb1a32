#pragma once
// Purpose: runs of voxels in pieces on which a plan with bent planes is a plan of flat ones, so that whatever counts flat plans
// counts bent ones. Frame: image, mm.
// A piece is a stretch that a bent plane leaves on one side altogether, or a single voxel; there the plane that touches the surface
// at the voxel's centre stands for it, moved by the difference between the mean height over the voxel and the height in its
// middle, sum of (width_a^2 d2h/da2) / 24. A volume's error is thus of fourth order in the voxel's width. Stretches are found by
// steps that the surface's steepest slope allows.

#include <cmath>
#include <vector>

#include "planning/volumetry/resected.h"

namespace glisson {

class FlatStretches {
 public:
  /// `plan` outlives this. Not thread-safe: each thread has its own.
  FlatStretches(const std::vector<ImageResection>& plan, const Vec3& spacing);

  /// Calls visit(piece, flat) for the pieces of `run` in order; `flat` has the plan's resections with their planes, the bent ones
  /// behind the flat ones, and is valid during the call.
  template <typename Visit>
  void along(const RowRun& run, Visit&& visit) {
    const int end = run.i + run.n;
    for (Bent& bent : bends_) {
      bent.until = run.i;
    }
    for (int i = run.i; i < end;) {
      int stop = end;
      for (Bent& bent : bends_) {
        if (bent.until <= i) {
          decide(bent, {i, run.j, run.k, end - i});
        }
        stop = std::min(stop, bent.until);
      }
      visit(RowRun{i, run.j, run.k, stop - i}, bends_.empty() ? plan_ : flat_);
      i = stop;
    }
  }

  /// What along() is called for lies in this box until the next call: there a single bent plane's slopes are known better, and the
  /// pieces that it leaves on one side are longer. What is counted of them stays the same.
  void stayWithin(const Box& box);

  /// The same for a box of voxels that every bent plane leaves on one side altogether; null where one may cross it.
  [[nodiscard]] const std::vector<ImageResection>* over(const Box& box);

 private:
  struct Changes {
    double reach = 0;  ///< of above() within one voxel
    Range perVoxel;    ///< from one voxel to the next of a run
  };
  struct Bent {
    const BentSurface* surface = nullptr;
    std::size_t resection = 0;
    std::size_t plane = 0;  ///< in flat_
    double slack = 0;       ///< how far its stand-ins may be from it, along its normal
    Changes everywhere;
    Changes here;
    int until = 0;  ///< the plane in flat_ is right up to this voxel
  };
  [[nodiscard]] static Changes changesEverywhere(const BentSurface& surface, const Vec3& spacing);
  [[nodiscard]] Changes changesWithin(const Box& box, const Bent& bent) const;
  void decide(Bent& bent, const RowRun& rest);

  const std::vector<ImageResection>& plan_;
  Vec3 spacing_;
  std::vector<ImageResection> flat_;
  std::vector<Bent> bends_;
};

/// The plane that stands for the surface in one voxel.
ImagePlane planeIn(const Box& voxel, const BentSurface& surface);

/// The points y, seen from a box's centre, with |slope . y + above| <= off.
struct Slab {
  Vec3 slope = Vec3::UnitZ();
  double above = 0;
  double off = 0;
};
/// Where the surface is within the box, by the plane that touches it under the centre and its curvature.
Slab slabOf(const Box& box, const BentSurface& surface);

/// How far the surface can be from planeIn() within the voxel, mm, by its curvature.
double flatteningMm(const Box& voxel, const BentSurface& surface);
/// The most that flatteningMm() is for any voxel of a plan; 0 for flat ones.
double mostFlatteningMm(const std::vector<ImageResection>& plan, const Vec3& spacing);

bool hasBends(const std::vector<ImageResection>& plan);

}  // namespace glisson
