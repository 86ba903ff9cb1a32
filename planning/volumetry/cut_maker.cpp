#include "planning/volumetry/cut_maker.h"

#include <algorithm>

#include "planning/volumetry/run_counter.h"

namespace glisson {

namespace {
/// Appends the parts of `polygon` outside resections from `next` on (but `own`), the polygon lying on `plane` of resection `own`.
void appendOutside(Polygon polygon, const ImagePlane& plane, std::size_t own, std::size_t next, const Box& box,
                   const std::vector<ImageResection>& plan, std::vector<Polygon>& parts) {
  if (polygon.empty()) {
    return;
  }
  if (next == own) {
    ++next;
  }
  if (next >= plan.size()) {
    parts.push_back(std::move(polygon));
    return;
  }
  if (std::ranges::any_of(plan[next].planes, [&](const ImagePlane& other) { return sideOf(box, other) == RunSide::Outside; })) {
    appendOutside(std::move(polygon), plane, own, next + 1, box, plan, parts);
    return;
  }
  const double reach = 2 * box.half.norm();
  Polygon inside = std::move(polygon);
  for (const ImagePlane& other : plan[next].planes) {
    const Coplanar same = coplanar(plane, other, box.centre, reach);
    if (same == Coplanar::Same && own < next) {
      // One surface, two resections: the first one has it.
      appendOutside(std::move(inside), plane, own, next + 1, box, plan, parts);
      return;
    }
    if (same != Coplanar::No) {
      continue;
    }
    appendOutside(clipped(inside, {-other.normal, -other.offset}), plane, own, next + 1, box, plan, parts);
    inside = clipped(inside, other);
    if (inside.empty()) {
      return;
    }
  }
  if (plan[next].planes.empty()) {
    appendOutside(std::move(inside), plane, own, next + 1, box, plan, parts);
  }
}

/// The section of the box by one plane, where it bounds its own resection.
Polygon ownSection(const Box& box, const ImageResection& resection, std::size_t index) {
  const ImagePlane& plane = resection.planes[index];
  if (sideOf(box, plane) != RunSide::Across) {
    return {};
  }
  Polygon polygon = sectionOf(box, plane);
  const double reach = 2 * box.half.norm();
  for (std::size_t m = 0; m < resection.planes.size() && !polygon.empty(); ++m) {
    if (m == index) {
      continue;
    }
    const Coplanar same = coplanar(plane, resection.planes[m], box.centre, reach);
    if (same == Coplanar::Opposite || (same == Coplanar::Same && m < index)) {
      return {};
    }
    if (same == Coplanar::No) {
      polygon = clipped(polygon, resection.planes[m]);
    }
  }
  return polygon;
}
}  // namespace

bool CutMaker::isCrossed(const Box& box, const std::vector<ImageResection>& flat) {
  return std::any_of(flat.begin(), flat.end(), [&](const ImageResection& resection) {
    return std::any_of(resection.planes.begin(), resection.planes.end(),
                       [&](const ImagePlane& plane) { return sideOf(box, plane) == RunSide::Across; });
  });
}

void CutMaker::appendPieces(const Box& box, std::size_t run, const std::vector<ImageResection>& flat,
                            std::vector<CutPiece>& pieces) {
  if (RunCounter(spacing_, flat, counted_).sideOfBox(box) == RunSide::Inside) {
    return;  // one resection has all of it
  }
  for (std::size_t r = 0; r < flat.size(); ++r) {
    for (std::size_t p = 0; p < flat[r].planes.size(); ++p) {
      parts_.clear();
      appendOutside(ownSection(box, flat[r], p), flat[r].planes[p], r, 0, box, flat, parts_);
      // The bent planes are behind the flat ones, and what one cuts is a single voxel.
      const std::size_t flats = plan_[r].planes.size();
      const double off = p < flats || parts_.empty() ? 0.0 : flatteningMm(box, plan_[r].bends[p - flats]);
      for (Polygon& part : parts_) {
        pieces.push_back({std::move(part), run, r, flat[r].planes[p].normal, off});
      }
    }
  }
}

bool CutMaker::mayCut(const Box& box) {
  const std::vector<ImageResection>* flat = stretches_.over(box);
  return flat == nullptr || RunCounter(spacing_, *flat, counted_).sideOfBox(box) == RunSide::Across;
}

}  // namespace glisson
