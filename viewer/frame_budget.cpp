#include "viewer/frame_budget.h"

#include <algorithm>

namespace glisson {

FramePlan FrameBudget::plan(FrameQuality quality, TriangleCounts triangles, bool anyTranslucent) const {
  FramePlan frame;
  frame.quality = quality;
  if (quality == FrameQuality::Moving) {
    frame.scale = moving_.ms > 0.5 * kFrameBudgetMs ? 0.5 : 1.0;
    return frame;
  }
  if (quality == FrameQuality::Picture || quality == FrameQuality::Report) {
    frame.detail = quality == FrameQuality::Picture ? Detail::Full : Detail::Reduced;
    frame.peels = anyTranslucent;
    frame.smoothEdges = true;
    return frame;
  }
  const double reducedMs = plain_[static_cast<std::size_t>(Detail::Reduced)].ms;
  const double share = static_cast<double>(triangles.full) / static_cast<double>(std::max<std::size_t>(triangles.reduced, 1));
  const bool fullFits = triangles.full <= triangles.reduced || (reducedMs > 0 && reducedMs * share <= 0.5 * kFrameBudgetMs);
  frame.detail = fullFits ? Detail::Full : Detail::Reduced;
  const double plainMs = plain_[static_cast<std::size_t>(frame.detail)].ms;
  const double peeledMs = peeled_[static_cast<std::size_t>(frame.detail)].ms;
  const double expectedMs = peeledMs > 0 ? peeledMs : plainMs * kRestingPeels;
  frame.peels = anyTranslucent && plainMs > 0 && expectedMs <= kFrameBudgetMs;
  frame.smoothEdges = plainMs > 0 && plainMs < 0.5 * kFrameBudgetMs;
  return frame;
}

bool FrameBudget::remember(const FramePlan& frame, double ms) {
  const bool resting = frame.quality == FrameQuality::Resting;
  if ((!resting && frame.quality != FrameQuality::Moving) || frame.scale < 1.0) {
    return false;
  }
  if (frame.uploads) {
    return resting;
  }
  FrameTime& time = resting ? (frame.peels ? peeled_ : plain_)[static_cast<std::size_t>(frame.detail)] : moving_;
  ++time.frames;
  if (resting && !frame.peels) {
    constexpr double kRecovers = 0.98;  // after some frames without it peeling is tried again
    peeled_[static_cast<std::size_t>(frame.detail)].ms *= kRecovers;
  }
  if (time.frames >= 2) {
    constexpr double kForgotten = 0.8;  // one quick frame among slow ones proves nothing
    time.ms = std::max({ms, kForgotten * time.ms, 0.1});
  }
  return resting && time.frames <= 2;
}

bool FrameBudget::restingIsSlow() const {
  return std::ranges::any_of(plain_, [](const FrameTime& time) { return time.ms > kFrameBudgetMs; });
}

void FrameBudget::forget() { *this = {}; }

void FrameBudget::areaChanged(double factor) {
  moving_.ms *= factor;
  for (std::size_t d = 0; d < kDetails; ++d) {
    plain_[d].ms *= factor;
    peeled_[d].ms *= factor;
  }
}

}  // namespace glisson
