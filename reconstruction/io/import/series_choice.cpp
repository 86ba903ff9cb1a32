// Which of a folder's images are the series that is meant, and that none of its slices is left behind.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "reconstruction/errors.h"
#include "reconstruction/io/import/slice_stack.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
bool sameGrid(const DicomSlice& a, const DicomSlice& b) {
  return a.rows == b.rows && a.columns == b.columns && a.localizer == b.localizer && a.placed == b.placed &&
         std::abs(a.rowSpacing - b.rowSpacing) < 1e-4 && std::abs(a.columnSpacing - b.columnSpacing) < 1e-4 &&
         (a.rowDirection - b.rowDirection).norm() < 1e-3 && (a.columnDirection - b.columnDirection).norm() < 1e-3;
}

using Group = std::vector<DicomSlice>;

std::vector<Group> groupsOf(std::vector<DicomSlice>&& slices) {
  std::vector<Group> groups;
  for (DicomSlice& slice : slices) {
    const auto group = std::ranges::find_if(groups, [&](const Group& known) {
      return known.front().seriesUid == slice.seriesUid && known.front().modality == slice.modality &&
             sameGrid(known.front(), slice);
    });
    if (group == groups.end()) {
      groups.push_back({std::move(slice)});
    } else {
      group->push_back(std::move(slice));
    }
  }
  return groups;
}

/// A group of this many images could be the volume that is meant; fewer are a localizer, an excerpt or a report.
constexpr std::size_t kVolumeImages = 10;

bool sameSeries(const DicomSlice& a, const DicomSlice& b) {
  if (a.seriesUid.empty() || b.seriesUid.empty()) {
    return a.path.parent_path() == b.path.parent_path();
  }
  return a.seriesUid == b.seriesUid;
}

/// A few images across the series' direction that do not lie where its slices lie, whatever they call themselves.
bool isLocalizerOf(const Group& series, const Group& group) {
  constexpr double kAcross = 0.9;  // cosine of about 25 degrees
  constexpr double kBesideMm = 1;
  constexpr double kSamePositionMm = 0.01;
  const DicomSlice& first = series.front();
  if (group.front().localizer) {
    return true;
  }
  if (!group.front().placed || group.size() >= std::min(kVolumeImages, series.size()) ||
      std::abs(group.front().normal().dot(first.normal())) > kAcross) {
    return false;
  }
  const Vec3 along = series.back().position - first.position;
  const Vec3 line = along.norm() > kSamePositionMm ? Vec3(along.normalized()) : first.normal();
  return std::ranges::all_of(group, [&](const DicomSlice& slice) {
    const Vec3 offset = slice.position - first.position;
    return (offset - offset.dot(line) * line).norm() > kBesideMm;
  });
}

/// What parts an image from the series it belongs to.
std::string difference(const DicomSlice& series, const DicomSlice& odd) {
  if (!odd.placed) {
    return odd.flaw;
  }
  if (odd.seriesUid != series.seriesUid) {
    return odd.seriesUid.empty() ? "does not say to which series it belongs"
                                 : "says that it belongs to another series than the rest";
  }
  const std::string others = ", unlike the other slices of its series";
  if (odd.rows != series.rows || odd.columns != series.columns) {
    return "has " + std::to_string(odd.rows) + " rows and " + std::to_string(odd.columns) + " columns" + others + " (" +
           std::to_string(series.rows) + " and " + std::to_string(series.columns) + ")";
  }
  if (odd.modality != series.modality) {
    return "is of modality " + odd.modality + others;
  }
  if (std::abs(odd.rowSpacing - series.rowSpacing) >= 1e-4 || std::abs(odd.columnSpacing - series.columnSpacing) >= 1e-4) {
    return "has a pixel spacing of " + formatNumber(odd.rowSpacing, 4) + " x " + formatNumber(odd.columnSpacing, 4) + " mm" +
           others + " (" + formatNumber(series.rowSpacing, 4) + " x " + formatNumber(series.columnSpacing, 4) + " mm)";
  }
  return "has another orientation than the other slices of its series";
}

/// Whether an image lies one step from a slice of the series, where none is: it fills a gap or goes on at an end.
bool continues(const Group& series, const DicomSlice& odd) {
  constexpr double kBesideMm = 0.1;
  DicomSlice alike = odd;
  alike.localizer = false;
  if (series.size() < 3 || !sameGrid(series.front(), alike)) {
    return false;
  }
  const DicomSlice& first = series.front();
  const Vec3 normal = first.normal();
  std::vector<double> heights;
  std::ranges::transform(series, std::back_inserter(heights), [&](const DicomSlice& slice) { return normal.dot(slice.position); });
  std::ranges::sort(heights);
  const double step = (heights.back() - heights.front()) / static_cast<double>(heights.size() - 1);
  const Vec3 offset = odd.position - first.position;
  const double height = normal.dot(odd.position);
  const auto next = std::ranges::min_element(heights, {}, [&](double other) { return std::abs(other - height); });
  return (offset - offset.dot(normal) * normal).norm() < kBesideMm && step > 0 &&
         std::abs(std::abs(*next - height) / step - 1) < 0.1;
}

/// A slice that left its series by a broken header must not be missed silently, least of all at an end, where no gap shows it.
void requireWholeSeries(const Group& series, const Group& group) {
  if (sameSeries(series.front(), group.front()) && !isLocalizerOf(series, group)) {
    throw InputError(group.front().path.string() + " " + difference(series.front(), group.front()) +
                     "; copy or export the series again.");
  }
  const auto odd = std::ranges::find_if(group, [&](const DicomSlice& slice) { return continues(series, slice); });
  if (group.size() < std::min(kVolumeImages, series.size()) && odd != group.end()) {
    throw InputError(odd->path.string() + " lies where the series of " + series.front().path.filename().string() +
                     " lacks a slice or goes on, but says that it is " + (odd->localizer ? "a localizer" : "of another series") +
                     "; export the series again, or take that file out of the folder.");
  }
}

std::string describe(const Group& group) {
  const DicomSlice& first = group.front();
  const std::string& called = first.identity.seriesDescription;
  const std::string which = first.localizer            ? " (localizer)"
                            : !called.empty()          ? " of the series \"" + called + "\""
                            : !first.seriesUid.empty() ? " of the series " + first.seriesUid
                                                       : "";
  return std::to_string(group.size()) + (group.size() == 1 ? " image" : " images") + which + ", such as " +
         first.path.filename().string();
}

/// Neither the larger of two volumes nor one of two patients is chosen silently.
void requireOneSeries(const std::string& name, const Group& chosen, const Group& other) {
  const DicomSlice& a = chosen.front();
  const DicomSlice& b = other.front();
  if (b.localizer || sameSeries(a, b)) {
    return;
  }
  const bool patients =
      !a.identity.patientId.empty() && !b.identity.patientId.empty() && a.identity.patientId != b.identity.patientId;
  const bool volumes = std::min(chosen.size(), other.size()) >= kVolumeImages && b.placed && a.modality == b.modality;
  if (patients || volumes) {
    throw InputError(name + " holds two series" + (patients ? " of different patients" : "") + ": " + describe(chosen) + ", and " +
                     describe(other) + "; give the folder of one, or one slice of it instead of the folder.");
  }
}

}  // namespace

std::vector<DicomSlice> chooseSeries(const std::string& name, std::vector<DicomSlice>&& slices,
                                     const std::filesystem::path& preferred, std::vector<std::string>& notes) {
  std::vector<Group> groups = groupsOf(std::move(slices));
  const auto rank = [&](const Group& group) {
    const bool wanted = std::ranges::any_of(group, [&](const DicomSlice& slice) { return slice.path == preferred; });
    const bool image = !group.front().localizer && group.front().placed;
    return std::tuple(wanted && !preferred.empty(), image, group.size());
  };
  const auto best = std::ranges::max_element(groups, {}, rank);
  if (best == groups.end()) {
    throw InputError(name + " holds no DICOM slice that can be read as a volume; choose the folder with the slices.");
  }
  if (best->front().localizer) {
    throw InputError(name + " holds only localizer images; choose the folder with the slices.");
  }
  if (!best->front().placed) {
    throw InputError(best->front().path.string() + " " + best->front().flaw + "; copy or export the series again.");
  }
  for (const Group& group : groups) {
    if (&group != &*best) {
      requireWholeSeries(*best, group);
      if (preferred.empty()) {
        requireOneSeries(name, *best, group);
      }
      notes.push_back("Left out: " + describe(group) + ".");
    }
  }
  return std::move(*best);
}

}  // namespace glisson::import
