#pragma once
// Purpose: how good the next frame of the 3D view may be so that the window answers within its budget, also where OpenGL runs in
// software: chosen from what earlier frames have taken. Knows no Qt and no VTK. Times in milliseconds.

#include <array>
#include <cstddef>
#include <cstdint>

namespace glisson {

/// What a view may take of the 100 ms within which the window answers (reliability.md): in a drag the slices are painted in the
/// same turn, and frames of one kind differ by a third.
inline constexpr double kFrameBudgetMs = 65.0;

/// Moving: as fast as possible (coarse meshes, no peeling). Resting: reduced meshes; full ones and peeling where they fit into
/// kFrameBudgetMs. Report: reduced meshes with peeling, the same on every machine. Picture: full meshes, exact peeling, whatever it
/// costs.
enum class FrameQuality : std::uint8_t { Moving, Resting, Report, Picture };

/// How finely a surface is drawn.
enum class Detail : std::uint8_t { Coarse, Reduced, Full };
inline constexpr std::size_t kDetails = 3;

/// Triangles that a frame would draw of all visible structures.
struct TriangleCounts {
  std::size_t reduced = 0;
  std::size_t full = 0;
};

struct FramePlan {
  FrameQuality quality = FrameQuality::Moving;
  Detail detail = Detail::Coarse;
  bool peels = false;         ///< depth peeling
  bool smoothEdges = false;   ///< FXAA
  double scale = 1;           ///< resolution of the frame; moving frames that would miss the budget are drawn at half
  bool uploads = false;       ///< shows meshes that were not on the GPU before: what it takes says nothing about the next
  bool moreToUpload = false;  ///< and leaves some for the next
};

class FrameBudget {
 public:
  static constexpr int kRestingPeels = 4;

  /// Full meshes at rest only where the time of reduced frames, scaled by the triangles to draw, leaves half of the budget; peeling
  /// only where kRestingPeels times a plain frame of the same meshes fits.
  [[nodiscard]] FramePlan plan(FrameQuality quality, TriangleCounts triangles, bool anyTranslucent) const;
  /// A frame took this long. True where another one is worth drawing soon: to measure it, to peel, or to show more detail.
  bool remember(const FramePlan& frame, double ms);
  /// A full frame without peeling takes longer than the budget.
  [[nodiscard]] bool restingIsSlow() const;
  /// The set of meshes has changed: old times say nothing.
  void forget();
  /// The area to draw has changed by this factor: the old times tell about the new ones.
  void areaChanged(double factor);

 private:
  /// What frames of one kind take.
  struct FrameTime {
    double ms = 0;   ///< of the last one, or most of a slower one before; 0: unknown
    int frames = 0;  ///< drawn so far; the first also compiles, so its time is not kept
  };
  FrameTime moving_;
  std::array<FrameTime, kDetails> plain_;   ///< of resting frames without peeling, by detail
  std::array<FrameTime, kDetails> peeled_;  ///< of resting frames with it
};

}  // namespace glisson
