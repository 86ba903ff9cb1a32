#pragma once
// Purpose: the pieces of the resection surface in one run of voxels after the other (resected.h says which). Frame: image, mm.

#include <vector>

#include "planning/volumetry/flat_stretches.h"

namespace glisson {

class CutMaker {
 public:
  /// `plan` and `spacing` outlive this. Not thread-safe: each thread has its own.
  CutMaker(const std::vector<ImageResection>& plan, const Vec3& spacing)
      : plan_(plan), spacing_(spacing), stretches_(plan, spacing) {}

  /// Appends the pieces in `run`, which is number `number` among its rows; of its stretches only those whose box is `wanted`.
  template <typename Wanted>
  void append(const RowRun& run, std::size_t number, std::vector<CutPiece>& pieces, const Wanted& wanted) {
    stretches_.along(run, [&](const RowRun& stretch, const std::vector<ImageResection>& flat) {
      const Box box = boxOf(stretch, spacing_);
      if (isCrossed(box, flat) && wanted(box)) {
        appendPieces(box, number, flat, pieces);
      }
    });
  }
  void append(const RowRun& run, std::size_t number, std::vector<CutPiece>& pieces) {
    append(run, number, pieces, [](const Box&) { return true; });
  }

  /// Until the next call, all runs lie in this box: they are gone through faster.
  void stayWithin(const Box& box) { stretches_.stayWithin(box); }

  /// False where a box of voxels surely has no piece.
  [[nodiscard]] bool mayCut(const Box& box);

 private:
  [[nodiscard]] static bool isCrossed(const Box& box, const std::vector<ImageResection>& flat);
  void appendPieces(const Box& box, std::size_t run, const std::vector<ImageResection>& flat, std::vector<CutPiece>& pieces);

  const std::vector<ImageResection>& plan_;
  const Vec3& spacing_;
  FlatStretches stretches_;
  std::vector<Polygon> parts_;  ///< scratch space
  Resected counted_;            ///< scratch space
};

}  // namespace glisson
