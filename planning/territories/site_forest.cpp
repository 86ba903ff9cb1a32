#include "planning/territories/site_forest.h"

#include <algorithm>
#include <queue>

#include "planning/infinity.h"
#include "planning/territories/place.h"

namespace glisson {

namespace {
using Entry = std::pair<double, std::int32_t>;
using NearestFirst = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

constexpr double kSpurRadii = 1.5;  ///< from the middle of a vessel: its wall, where the way is oblique or the border rough

}  // namespace

SiteForest::SiteForest(const CentrelineLinks& links, double voxelMm)
    : links_(links),
      voxelMm_(voxelMm),
      wayMm_(links.sites.size(), kInfinity),
      parent_(links.sites.size(), -1),
      children_(links.sites.size(), 0),
      removed_(links.sites.size(), 0) {}

std::vector<Sites> SiteForest::pieces() const {
  std::vector<Sites> found;
  std::vector<std::uint8_t> seen(links_.sites.size(), 0);
  for (std::int32_t seed = 0; at(seed) < seen.size(); ++seed) {
    if (seen[at(seed)] != 0) {
      continue;
    }
    Sites piece{seed};
    seen[at(seed)] = 1;
    for (std::size_t n = 0; n < piece.size(); ++n) {
      for (const SiteLink& link : links_.of(piece[n])) {
        if (seen[at(link.to)] == 0) {
          seen[at(link.to)] = 1;
          piece.push_back(link.to);
        }
      }
    }
    std::sort(piece.begin(), piece.end());
    found.push_back(std::move(piece));
  }
  return found;
}

std::int32_t SiteForest::grow(const Sites& piece, const Sites& sources) {
  for (const std::int32_t s : piece) {
    wayMm_[at(s)] = kInfinity;
    parent_[at(s)] = -1;
    children_[at(s)] = 0;
  }
  NearestFirst open;
  for (const std::int32_t s : sources) {
    wayMm_[at(s)] = 0;
    open.emplace(0.0, s);
  }
  std::int32_t farthest = sources.front();
  while (!open.empty()) {
    const auto [mm, s] = open.top();
    open.pop();
    if (mm > wayMm_[at(s)]) {
      continue;
    }
    farthest = mm > wayMm_[at(farthest)] ? s : farthest;
    for (const SiteLink& link : links_.of(s)) {
      if (!removed(link.to) && mm + link.mm < wayMm_[at(link.to)]) {
        wayMm_[at(link.to)] = mm + link.mm;
        parent_[at(link.to)] = s;
        open.emplace(mm + link.mm, link.to);
      }
    }
  }
  for (const std::int32_t s : piece) {
    if (parent_[at(s)] >= 0) {
      ++children_[at(parent_[at(s)])];
    }
  }
  return farthest;
}

std::int32_t SiteForest::junctionAbove(std::int32_t end) const {
  std::int32_t s = parent_[at(end)];
  while (s >= 0 && children_[at(s)] < 2) {
    s = parent_[at(s)];
  }
  return s;
}

double SiteForest::spurLimit(std::int32_t junction) const {
  return std::max(kSpurRadii * links_.sites[at(junction)].radiusMm, 2 * voxelMm_);
}

void SiteForest::pruneEnds(const Sites& piece) {
  NearestFirst waiting;
  const auto add = [&](std::int32_t end) {
    const std::int32_t junction = junctionAbove(end);
    if (junction >= 0 && lengthBetween(end, junction) < spurLimit(junction)) {
      waiting.emplace(lengthBetween(end, junction), end);
    }
  };
  for (const std::int32_t s : piece) {
    if (!removed(s) && children_[at(s)] == 0) {
      add(s);
    }
  }
  while (!waiting.empty()) {
    const auto [mm, end] = waiting.top();
    waiting.pop();
    const std::int32_t junction = junctionAbove(end);
    if (junction < 0) {
      continue;
    }
    if (lengthBetween(end, junction) > mm) {
      add(end);  // its junction went with another spur: it reaches farther up now
      continue;
    }
    for (std::int32_t s = end; s != junction; s = parent_[at(s)]) {
      removed_[at(s)] = 1;
    }
    --children_[at(junction)];
  }
}

std::int32_t SiteForest::onlyChild(std::int32_t site) const {
  for (const SiteLink& link : links_.of(site)) {
    if (!removed(link.to) && parent_[at(link.to)] == site) {
      return link.to;
    }
  }
  return -1;
}

std::int32_t SiteForest::prune(const Sites& piece, std::int32_t root) {
  pruneEnds(piece);
  std::int32_t junction = root;
  while (children_[at(junction)] == 1) {
    junction = onlyChild(junction);
  }
  if (children_[at(junction)] < 2 || wayMm_[at(junction)] >= spurLimit(junction)) {
    return root;
  }
  for (std::int32_t s = parent_[at(junction)]; s >= 0; s = parent_[at(s)]) {
    removed_[at(s)] = 1;
  }
  parent_[at(junction)] = -1;
  return junction;
}

Sites SiteForest::endsOf(const Sites& piece, std::int32_t root) const {
  Sites ends;
  for (const std::int32_t s : piece) {
    if (!removed(s) && (children_[at(s)] == 0 || (s == root && children_[at(s)] == 1))) {
      ends.push_back(s);
    }
  }
  return ends;
}

Sites SiteForest::fromEnd(std::int32_t end, double mm) const {
  Sites way{end};
  const bool down = children_[at(end)] == 1;  // the root's end
  while (std::abs(wayMm_[at(way.back())] - wayMm_[at(end)]) < mm) {
    const std::int32_t next = down ? onlyChild(way.back()) : parent_[at(way.back())];
    if (next < 0) {
      break;
    }
    way.push_back(next);
    if (children_[at(next)] != 1) {
      break;
    }
  }
  return way;
}

}  // namespace glisson
