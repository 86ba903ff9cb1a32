#include "reconstruction/io/import/slice_stack.h"

#include <algorithm>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr double kSamePositionMm = 0.01;
constexpr double kTiltDegrees = 0.1;

/// reliability.md: the deviation of a slice distance that makes a series uneven.
double toleranceOf(double step) { return std::max(0.05, 0.01 * step); }

double degrees(double radians) { return radians * 180 / 3.14159265358979323846; }

std::string nameOf(const DicomSlice& slice) { return slice.path.filename().string(); }

/// Drops slices at a position that is taken already (with consent) and returns what to say about them.
std::string dropDuplicates(const std::string& name, std::vector<DicomSlice>& slices, const Vec3& normal) {
  const auto apart = [&](std::size_t a, std::size_t b) { return normal.dot(slices[b].position - slices[a].position); };
  std::vector<std::size_t> kept{0};
  std::vector<std::size_t> copies{1};
  std::string firstPair;
  for (std::size_t n = 1; n < slices.size(); ++n) {
    if (apart(kept.back(), n) > kSamePositionMm) {
      kept.push_back(n);
      copies.push_back(1);
      continue;
    }
    ++copies.back();
    if (firstPair.empty()) {
      firstPair = nameOf(slices[kept.back()]) + " and " + nameOf(slices[n]);
    }
  }
  if (kept.size() == 1) {
    throw InputError(name + " is not a volume: all " + std::to_string(slices.size()) +
                     " images lie at one position; choose the series with the volume.");
  }
  if (kept.size() == slices.size()) {
    return {};
  }
  if (std::ranges::all_of(copies, [&](std::size_t n) { return n == copies.front(); })) {
    throw InputError(name + " holds " + std::to_string(copies.front()) +
                     " images at every position, so it is a time series or several phases; give the folder of one phase.");
  }
  std::string fact =
      std::to_string(slices.size() - kept.size()) + " slice(s) lie where another one lies already (" + firstPair + ")";
  std::vector<DicomSlice> rest;
  rest.reserve(kept.size());
  for (const std::size_t n : kept) {
    rest.push_back(std::move(slices[n]));
  }
  slices = std::move(rest);
  return fact;
}

std::string unevenText(const std::vector<DicomSlice>& slices, const std::vector<double>& distance, double step) {
  const double tolerance = toleranceOf(step);
  const auto steps = static_cast<double>(slices.size() - 1);
  const double mean = distance.back() / steps;
  for (std::size_t n = 0; n + 1 < slices.size(); ++n) {
    const double gap = distance[n + 1] - distance[n];
    // The mean is off where a slice is missing, the median where distances alternate.
    if (std::min(std::abs(gap - step), std::abs(gap - mean)) > tolerance) {
      return "between " + nameOf(slices[n]) + " and " + nameOf(slices[n + 1]) + " there are " + formatNumber(gap, 3) +
             " mm instead of " + formatNumber(step, 3) + " mm (a missing or uneven slice)";
    }
  }
  for (std::size_t n = 0; n < slices.size(); ++n) {
    const double off = distance[n] - distance.back() * static_cast<double>(n) / steps;
    if (std::abs(off) > tolerance) {
      return "the slice " + nameOf(slices[n]) + " lies " + formatNumber(off, 3) + " mm off the even spacing";
    }
  }
  return {};
}

/// No consent makes a volume of slices with half a metre of nothing between them: a position is broken.
void requireNoChasm(const std::vector<DicomSlice>& slices, const std::vector<double>& distance) {
  constexpr double kChasmMm = 500;
  for (std::size_t n = 0; n + 1 < slices.size(); ++n) {
    if (distance[n + 1] - distance[n] > kChasmMm) {
      throw InputError(slices[n + 1].path.string() + " lies " + formatNumber(distance[n + 1] - distance[n], 1) + " mm from " +
                       nameOf(slices[n]) + ", so one of the two has a broken position; copy or export the series again.");
    }
  }
}

double medianStep(const std::vector<double>& distance) {
  std::vector<double> gaps;
  for (std::size_t n = 0; n + 1 < distance.size(); ++n) {
    gaps.push_back(distance[n + 1] - distance[n]);
  }
  std::ranges::nth_element(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2));
  return gaps[gaps.size() / 2];
}

void setRegularGrid(SliceStack& stack, const Mat3& axes) {
  const DicomSlice& first = stack.slices.front();
  const auto count = stack.slices.size();
  stack.geometry.size = {first.columns, first.rows, static_cast<int>(count)};
  stack.geometry.spacing = Vec3(first.columnSpacing, first.rowSpacing, stack.distance.back() / static_cast<double>(count - 1));
  stack.geometry.origin = first.position;
  stack.geometry.direction = axes;
  stack.shift.assign(count, Vec3::Zero());
}

/// The upright grid that holds every slice where it is.
void setResampledGrid(SliceStack& stack, const Mat3& axes, double step) {
  const DicomSlice& first = stack.slices.front();
  const Vec3 spacing(first.columnSpacing, first.rowSpacing, 1);
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  std::vector<Vec3> shifts;
  for (const DicomSlice& slice : stack.slices) {
    Vec3 shift = (axes.transpose() * (slice.position - first.position)).cwiseQuotient(spacing);
    for (int a = 0; a < 2; ++a) {  // rounding noise in the header is no shift
      shift[a] = std::abs(shift[a] * spacing[a]) < kSamePositionMm ? 0 : shift[a];
    }
    shifts.push_back(shift);
    low = low.cwiseMin(shift);
    high = high.cwiseMax(shift);
  }
  for (Vec3& shift : shifts) {
    shift -= low;
  }
  stack.shift = std::move(shifts);
  const double length = stack.distance.back();
  const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
  stack.geometry.size = {first.columns + static_cast<int>(std::ceil(high[0] - low[0])),
                         first.rows + static_cast<int>(std::ceil(high[1] - low[1])), steps + 1};
  stack.geometry.spacing = Vec3(spacing[0], spacing[1], length / steps);
  stack.geometry.origin = first.position + axes * Vec3(low[0] * spacing[0], low[1] * spacing[1], 0);
  stack.geometry.direction = axes;
  stack.resample = true;
}

void requireConsent(const std::string& name, const std::string& tilt, const std::string& uneven,
                    const std::set<Consent>& consents) {
  const bool needTilt = !tilt.empty() && !consents.contains(Consent::Tilt);
  const bool needUneven = !uneven.empty() && !consents.contains(Consent::UnevenSlices);
  if (!needTilt && !needUneven) {
    return;
  }
  const std::string fact = tilt + (!tilt.empty() && !uneven.empty() ? ", and " : "") + uneven;
  const std::string flags = std::string(tilt.empty() ? "" : "tilt") + (!tilt.empty() && !uneven.empty() ? "," : "") +
                            (uneven.empty() ? "" : "uneven-slices");
  throw InputError(name + " is no regular volume: " + fact + "; accept resampling it to a regular grid with --accept " + flags +
                   ".");
}
}  // namespace

SliceStack stackSlices(const std::string& name, std::vector<DicomSlice>&& slices, const std::set<Consent>& consents) {
  if (slices.size() < 2) {
    throw InputError(name + " is not a volume: it holds a single slice; choose the folder with the whole series.");
  }
  const Vec3 normal = slices.front().normal();
  std::ranges::stable_sort(slices, {}, [](const DicomSlice& slice) { return slice.instanceNumber; });
  std::ranges::stable_sort(slices, {}, [&](const DicomSlice& slice) { return normal.dot(slice.position); });
  std::string uneven = dropDuplicates(name, slices, normal);
  SliceStack stack;
  for (const DicomSlice& slice : slices) {
    stack.distance.push_back(normal.dot(slice.position - slices.front().position));
  }
  requireNoChasm(slices, stack.distance);
  const double step = medianStep(stack.distance);
  if (const std::string gap = unevenText(slices, stack.distance, step); !gap.empty()) {
    uneven += (uneven.empty() ? "" : ", and ") + gap;
  }
  const Vec3 along = slices.back().position - slices.front().position;
  double sideways = 0;
  for (std::size_t n = 0; n < slices.size(); ++n) {
    const Vec3 offset = slices[n].position - slices.front().position - along * (stack.distance[n] / stack.distance.back());
    sideways = std::max(sideways, offset.norm());
  }
  const double tiltDegrees = degrees(std::atan2(along.cross(normal).norm(), along.dot(normal)));
  std::string tilt;
  if (tiltDegrees > kTiltDegrees) {
    tilt = "the gantry was tilted by " + formatNumber(tiltDegrees, 1) + " degrees";
  } else if (sideways > 0.1) {
    tilt = "slices are shifted sideways by up to " + formatNumber(sideways, 2) + " mm";
  }
  requireConsent(name, tilt, uneven, consents);
  Mat3 axes;
  axes << slices.front().rowDirection, slices.front().columnDirection, normal;
  stack.slices = std::move(slices);
  if (tilt.empty() && uneven.empty()) {
    setRegularGrid(stack, axes);
    return stack;
  }
  setResampledGrid(stack, axes, step);
  for (const std::string& fact : {tilt, uneven}) {
    if (!fact.empty()) {
      stack.notes.push_back("Resampled to a regular grid with consent: " + fact + ".");
    }
  }
  return stack;
}

namespace {
/// A slice's value at grid index (i, j); nothing outside its pixels.
struct SliceSampler {
  const std::vector<std::int16_t>& pixels;
  int columns;
  int rows;
  bool nearest;
  double fill;

  [[nodiscard]] double at(double x, double y) const {
    if (x < -0.5 || y < -0.5 || x > columns - 0.5 || y > rows - 0.5) {
      return fill;
    }
    const double cx = std::clamp(x, 0.0, columns - 1.0);
    const double cy = std::clamp(y, 0.0, rows - 1.0);
    if (nearest) {
      return pixel(static_cast<int>(std::floor(cx + 0.5)), static_cast<int>(std::floor(cy + 0.5)));
    }
    const int i = std::min(static_cast<int>(cx), std::max(columns - 2, 0));
    const int j = std::min(static_cast<int>(cy), std::max(rows - 2, 0));
    const double fx = cx - i;
    const double fy = cy - j;
    const int i1 = std::min(i + 1, columns - 1);
    const int j1 = std::min(j + 1, rows - 1);
    return (pixel(i, j) * (1 - fx) + pixel(i1, j) * fx) * (1 - fy) + (pixel(i, j1) * (1 - fx) + pixel(i1, j1) * fx) * fy;
  }
  [[nodiscard]] double pixel(int i, int j) const {
    return pixels[static_cast<std::size_t>(std::min(i, columns - 1)) +
                  static_cast<std::size_t>(columns) * static_cast<std::size_t>(std::min(j, rows - 1))];
  }
};
}  // namespace

std::vector<std::int16_t> resampleSlices(const SliceStack& stack, const std::vector<std::vector<std::int16_t>>& pixels,
                                         bool nearest, std::int16_t fill) {
  const Index3& size = stack.geometry.size;
  const DicomSlice& first = stack.slices.front();
  std::vector<std::int16_t> values(stack.geometry.voxelCount());
  parallelFor(static_cast<std::size_t>(size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double at = std::min(static_cast<double>(k) * stack.geometry.spacing[2], stack.distance.back());
      const auto above = std::ranges::lower_bound(stack.distance, at - 1e-9);
      const auto b = std::min(static_cast<std::size_t>(above - stack.distance.begin()), stack.distance.size() - 1);
      const std::size_t a = b == 0 ? 0 : b - 1;
      const double gap = stack.distance[b] - stack.distance[a];
      double weight = gap > 0 ? std::clamp((at - stack.distance[a]) / gap, 0.0, 1.0) : 1.0;
      weight = nearest || weight > 1 - 1e-9 ? std::round(weight) : weight;
      const SliceSampler lower{pixels[a], first.columns, first.rows, nearest, static_cast<double>(fill)};
      const SliceSampler upper{pixels[b], first.columns, first.rows, nearest, static_cast<double>(fill)};
      std::size_t n = k * static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
      for (int j = 0; j < size[1]; ++j) {
        for (int i = 0; i < size[0]; ++i, ++n) {
          const double low = weight < 1 ? lower.at(i - stack.shift[a][0], j - stack.shift[a][1]) : 0;
          const double high = weight > 0 ? upper.at(i - stack.shift[b][0], j - stack.shift[b][1]) : 0;
          values[n] = static_cast<std::int16_t>(std::lround(low * (1 - weight) + high * weight));
        }
      }
    }
  });
  return values;
}

}  // namespace glisson::import
