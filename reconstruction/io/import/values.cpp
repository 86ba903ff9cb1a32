#include "reconstruction/io/import/values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
template <typename T>
std::size_t convert(const std::string& name, const ImageFile& file, std::vector<std::int16_t>& hounsfield) {
  constexpr double kLow = std::numeric_limits<std::int16_t>::min();
  constexpr double kHigh = std::numeric_limits<std::int16_t>::max();
  constexpr double kBeyondAnyScannerHu = 1e6;
  const bool plain = file.slope == 1 && file.intercept == 0;
  std::size_t clamped = 0;
  for (std::size_t n = 0; n < hounsfield.size(); ++n) {
    const T raw = valueAt<T>(file.bytes, n);
    if constexpr (std::is_same_v<T, std::int16_t>) {
      if (plain) {
        hounsfield[n] = raw;
        continue;
      }
    }
    const double value = std::round(static_cast<double>(raw) * file.slope + file.intercept);
    if (!std::isfinite(value)) {
      throw InputError(name + " holds voxels that are not finite numbers; export it again.");
    }
    if (std::abs(value) > kBeyondAnyScannerHu) {
      throw InputError(name + " holds no Hounsfield units: with its scale of " + formatExact(file.slope) +
                       " its values leave -32768..32767 by far; export it again.");
    }
    clamped += value < kLow || value > kHigh ? 1 : 0;
    hounsfield[n] = static_cast<std::int16_t>(std::clamp(value, kLow, kHigh));
  }
  return clamped;
}
}  // namespace

CtVolume toCt(const std::filesystem::path& path, ImageFile&& file) {
  const std::string name = path.string();
  if (file.layers != 1) {
    throw InputError(name + " holds several layers and is a segmentation, not a CT; open it as a segmentation.");
  }
  CtVolume ct;
  ct.geometry = file.geometry;
  ct.source = name;
  ct.notes = std::move(file.notes);
  ct.hounsfield.resize(ct.geometry.voxelCount());
  const std::size_t clamped = withType(file.scalar, [&](auto type) { return convert<decltype(type)>(name, file, ct.hounsfield); });
  file.bytes = {};
  checkHounsfield(name, ct, clamped);
  return ct;
}

void checkHounsfield(const std::string& name, CtVolume& ct, std::size_t clamped) {
  const auto [low, high] = std::ranges::minmax_element(ct.hounsfield);
  if (low == ct.hounsfield.end() || *low == *high) {
    throw InputError(name + " holds the same value in every voxel and is no CT; choose another series.");
  }
  if (std::ranges::all_of(ct.hounsfield,
                          [low = *low, high = *high](std::int16_t value) { return value == low || value == high; })) {
    throw InputError(name + " holds only the values " + std::to_string(*low) + " and " + std::to_string(*high) +
                     ", so it is a mask and no CT; open it as a segmentation.");
  }
  if (clamped > 0) {
    ct.notes.push_back(std::to_string(clamped) + " voxels lay beyond -32768..32767 HU and were set to the nearest of these.");
  }
  if (*low >= 0) {
    ct.notes.push_back("No voxel is below 0 HU (" + std::to_string(*low) + " to " + std::to_string(*high) +
                       "): these may be no Hounsfield units.");
  } else if (*high < -200) {
    ct.notes.push_back("No voxel is above " + std::to_string(*high) + " HU: these may be no Hounsfield units.");
  }
}

}  // namespace glisson::import
