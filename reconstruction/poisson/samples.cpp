// Oriented boundary samples of a mask [Palomar 2016, 2.1; method.md 1].
#include <array>
#include <cstring>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"
#include "reconstruction/poisson/poisson.h"

namespace glisson {

namespace {

/// The mask's box with two voxels of background around it, so that the Sobel kernel of a voxel beside the mask stays inside.
class PaddedMask {
 public:
  explicit PaddedMask(const Mask& mask) {
    for (std::size_t a = 0; a < 3; ++a) {
      size_[a] = mask.box().size[a] + 2 * kPad;
      first_[a] = mask.box().first[a] - kPad;
    }
    values_.assign(IndexBox{first_, size_}.voxelCount(), 0);
    const auto source = mask.values();
    const std::size_t row = static_cast<std::size_t>(mask.box().size[0]);
    std::size_t n = 0;
    for (int k = 0; k < mask.box().size[2]; ++k) {
      for (int j = 0; j < mask.box().size[1]; ++j, n += row) {
        std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(n), row,
                    values_.begin() + static_cast<std::ptrdiff_t>(offset(kPad, j + kPad, k + kPad)));
      }
    }
  }

  static constexpr int kPad = 2;
  [[nodiscard]] std::size_t offset(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(k));
  }
  [[nodiscard]] const std::uint8_t* data() const { return values_.data(); }
  [[nodiscard]] const Index3& size() const { return size_; }
  [[nodiscard]] const Index3& first() const { return first_; }

  /// Outward gradient -grad S in index space by the 3x3x3 Sobel kernels, times 32 (exact integers).
  [[nodiscard]] std::array<int, 3> outwardGradient(std::size_t at) const {
    const auto step = strides();
    std::array<int, 3> gradient{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::ptrdiff_t b = step[(a + 1) % 3];
      const std::ptrdiff_t c = step[(a + 2) % 3];
      const std::uint8_t* low = values_.data() + at - step[a];
      const std::uint8_t* high = values_.data() + at + step[a];
      gradient[a] = smooth(low, b, c) - smooth(high, b, c);
    }
    return gradient;
  }

  [[nodiscard]] std::array<std::ptrdiff_t, 3> strides() const {
    return {1, size_[0], static_cast<std::ptrdiff_t>(size_[0]) * size_[1]};
  }

 private:
  static int smooth(const std::uint8_t* p, std::ptrdiff_t b, std::ptrdiff_t c) {
    return p[-b - c] + 2 * p[-c] + p[b - c] + 2 * (p[-b] + 2 * p[0] + p[b]) + p[-b + c] + 2 * p[c] + p[b + c];
  }

  Index3 size_{};
  Index3 first_{};
  std::vector<std::uint8_t> values_;
};

Vec3 toWorldDirection(const std::array<int, 3>& gradient, const ImageGeometry& geometry) {
  return geometry.direction *
         Vec3(gradient[0] / geometry.spacing[0], gradient[1] / geometry.spacing[1], gradient[2] / geometry.spacing[2]);
}

/// The voxel centres of `paper` sampling in slice k of the padded grid.
void sampleSlicePaper(const PaddedMask& padded, const ImageGeometry& geometry, int k, OrientedPoints& out) {
  for (int j = 1; j + 1 < padded.size()[1]; ++j) {
    for (int i = 1; i + 1 < padded.size()[0]; ++i) {
      const std::size_t at = padded.offset(i, j, k);
      if (padded.data()[at] == 0) {
        continue;
      }
      const Vec3 normal = toWorldDirection(padded.outwardGradient(at), geometry);
      const double length = normal.norm();
      if (length == 0) {
        continue;
      }
      out.positions.push_back(geometry.toWorld(Vec3(i + padded.first()[0], j + padded.first()[1], k + padded.first()[2])));
      out.normals.push_back(normal / length);
      out.weights.push_back(1.0);
    }
  }
}

/// The end of the run of voxels from `at` on, at most `left` long, that are like their neighbours after them along every axis.
std::size_t alikeFrom(const std::uint8_t* data, std::size_t at, std::size_t left, const std::array<std::ptrdiff_t, 3>& step) {
  const auto eight = [](const std::uint8_t* p) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, p, sizeof(bytes));
    return bytes;
  };
  std::size_t n = 0;
  for (; n + sizeof(std::uint64_t) <= left; n += sizeof(std::uint64_t)) {
    const std::uint8_t* p = data + at + n;
    const std::uint64_t here = eight(p);
    if (((here ^ eight(p + step[0])) | (here ^ eight(p + step[1])) | (here ^ eight(p + step[2]))) != 0) {
      break;
    }
  }
  return n;
}

/// The faces of `unbiased` sampling whose lower voxel lies in slice k of the padded grid.
void sampleSliceUnbiased(const PaddedMask& padded, const ImageGeometry& geometry, int k, OrientedPoints& out) {
  const auto step = padded.strides();
  const double volume = geometry.voxelVolumeMm3();
  const auto* data = padded.data();
  for (int j = 1; j + 1 < padded.size()[1]; ++j) {
    for (int i = 1; i + 1 < padded.size()[0]; ++i) {
      // Most voxels lie deep inside or outside: they are passed eight at a time.
      i += static_cast<int>(alikeFrom(data, padded.offset(i, j, k), static_cast<std::size_t>(padded.size()[0] - 1 - i), step));
      if (i + 1 >= padded.size()[0]) {
        break;
      }
      const std::size_t at = padded.offset(i, j, k);
      for (int a = 0; a < 3; ++a) {
        const std::size_t beyond = at + static_cast<std::size_t>(step[static_cast<std::size_t>(a)]);
        if (data[at] == data[beyond]) {
          continue;
        }
        const Vec3 axis = geometry.direction.col(a) * (data[at] != 0 ? 1.0 : -1.0);
        const auto here = padded.outwardGradient(at);
        const auto there = padded.outwardGradient(beyond);
        Vec3 normal = toWorldDirection({here[0] + there[0], here[1] + there[1], here[2] + there[2]}, geometry);
        const double length = normal.norm();
        // A vanishing or inward mean gradient (thin vessels) says nothing about the surface: the face itself does.
        normal = length > 0 && normal.dot(axis) > 0 ? Vec3(normal / length) : axis;
        Vec3 centre(i + padded.first()[0], j + padded.first()[1], k + padded.first()[2]);
        centre[a] += 0.5;
        out.positions.push_back(geometry.toWorld(centre));
        out.normals.push_back(normal);
        out.weights.push_back(volume / geometry.spacing[a] * normal.dot(axis));
      }
    }
  }
}

}  // namespace

OrientedPoints sampleBoundary(const Mask& mask, const ImageGeometry& geometry, Sampling sampling, const ExecutionContext& context) {
  if (mask.empty()) {
    throw ReconstructionError("The mask has no voxel set; there is no surface to reconstruct.");
  }
  const PaddedMask padded(mask);
  std::vector<OrientedPoints> slices(static_cast<std::size_t>(padded.size()[2]));
  parallelFor(slices.size() - 2, 4, [&](std::size_t begin, std::size_t end) {
    context.throwIfCancelled();
    for (std::size_t n = begin; n < end; ++n) {
      const int k = static_cast<int>(n) + 1;
      if (sampling == Sampling::Paper) {
        sampleSlicePaper(padded, geometry, k, slices[n]);
      } else {
        sampleSliceUnbiased(padded, geometry, k, slices[n]);
      }
    }
  });
  OrientedPoints points;
  std::size_t count = 0;
  for (const auto& slice : slices) {
    count += slice.positions.size();
  }
  if (count == 0) {  // voxels alone: the gradient at their centres is zero
    throw ReconstructionError("No voxel of the mask has a gradient, so paper sampling finds no surface; use unbiased sampling.");
  }
  points.positions.reserve(count);
  points.normals.reserve(count);
  points.weights.reserve(count);
  for (const auto& slice : slices) {
    points.positions.insert(points.positions.end(), slice.positions.begin(), slice.positions.end());
    points.normals.insert(points.normals.end(), slice.normals.begin(), slice.normals.end());
    points.weights.insert(points.weights.end(), slice.weights.begin(), slice.weights.end());
  }
  return points;
}

}  // namespace glisson
