#pragma once
// Purpose: the connected pieces of the two sides of a plan inside L, and those of them that are given to the other side.
// Frame: image. Volumes in units of 2^-32 voxel, as resected.h counts.
// Two parts of neighbouring voxels are connected where both voxels have a part of that side and share a face. For one plane that is
// exact: each part is convex, so parts that meet two voxels of one box meet their common face. With several planes the parts of one
// voxel on one side count as one.
// A piece is the main one of the resected side where it holds the largest part of some resection, of the remnant where it is the
// largest. Every other piece is an island.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planning/volumetry/row_table.h"
#include "planning/volumetry/run_parts.h"

namespace glisson {

struct SidePiece {
  PlanSide side = PlanSide::Remnant;
  std::int64_t units = 0;
  bool main = false;
  bool switched = false;  ///< given to the other side
  Vec3 point;             ///< a voxel's centre inside it, image frame mm: in the middle of its longest run
};

class SidePieces {
 public:
  /// `liver`: L. Const afterwards but for switchAt().
  SidePieces(const VoxelRows& liver, const Vec3& spacing, const std::vector<ImageResection>& plan);

  /// Remnant and resected pieces in order of their first voxel.
  [[nodiscard]] const std::vector<SidePiece>& pieces() const { return pieces_; }
  /// The piece of `side` that has a part of the voxel.
  [[nodiscard]] std::optional<std::size_t> pieceAt(PlanSide side, int i, int j, int k) const;
  [[nodiscard]] std::optional<std::size_t> pieceAt(PlanSide side, const Vec3& image) const;

  /// Gives the island of the other side at `image` to side `to`; false where there is none.
  bool switchAt(const Vec3& image, PlanSide to);
  [[nodiscard]] bool anySwitched() const;
  /// The voxel's part of `side` lies in a piece that is given to the other side.
  [[nodiscard]] bool isSwitched(PlanSide side, const Index3& voxel) const;

  /// Units that the switched pieces bring to the resected side, of voxels `rows` (inside L or not; what is outside stays).
  /// `perPiece`, where given, gets each piece's units of these rows, switched or not.
  [[nodiscard]] std::int64_t switchedUnits(const VoxelRows& rows, const std::vector<ImageResection>& plan,
                                           std::vector<std::int64_t>* perPiece = nullptr) const;
  /// Whether a piece of the cut surface still has different sides once the islands are switched.
  [[nodiscard]] bool separates(const CutPiece& cut) const;

 private:
  [[nodiscard]] std::optional<std::size_t> partAt(int i, int j, int k) const;
  void connect();
  void measure(std::size_t resections);

  Vec3 spacing_;
  std::vector<RunPart> parts_;
  RowTable rows_;                                    ///< of the parts
  std::array<std::vector<std::uint32_t>, 2> piece_;  ///< of each part, by side; kNone where it has none
  std::vector<SidePiece> pieces_;
};

/// The sides' pieces, each island where the plan gives it; nothing where the plan gives none away. `resections`: the plan in the
/// image frame. What has no effect is said in `warning`, one sentence an island, where that is given.
std::optional<SidePieces> switchedSides(const VoxelRows& liver, const ImageGeometry& geometry, const ResectionPlan& plan,
                                        const std::vector<ImageResection>& resections, std::string* warning = nullptr);

}  // namespace glisson
