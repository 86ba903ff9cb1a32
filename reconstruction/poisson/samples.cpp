// Oriented boundary samples of a mask [Palomar 2016, 2.1; method.md 1].
#include "reconstruction/poisson/samples.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

/// Most voxels lie deep inside or outside: they are looked at eight at a time.
constexpr std::size_t kEight = sizeof(std::uint64_t);
/// Of eight voxels in a row: the component along axis a of voxel n is [a][n].
struct Gradients : std::array<std::array<std::int16_t, kEight>, 3> {
  Gradients() : std::array<std::array<std::int16_t, kEight>, 3>{} {}
  [[nodiscard]] std::array<int, 3> of(std::size_t n) const { return {(*this)[0][n], (*this)[1][n], (*this)[2][n]}; }
};

/// The mask's box with two voxels of background around it, so that the Sobel kernel of a voxel beside the mask stays inside.
class PaddedMask {
 public:
  explicit PaddedMask(const Mask& mask) {
    for (std::size_t a = 0; a < 3; ++a) {
      size_[a] = mask.box().size[a] + 2 * kPad;
      first_[a] = mask.box().first[a] - kPad;
    }
    // Gradients of eight voxels are found at once, and those of the voxels after them, wherever one of them is wanted: they read a
    // slice, a row and some voxels beyond the last ones.
    const std::size_t beyond = offset(kEight + 1, 1, 1);
    values_.resize(IndexBox{first_, size_}.voxelCount() + beyond);
    std::fill(values_.end() - static_cast<std::ptrdiff_t>(beyond), values_.end(), std::uint8_t{0});
    const auto source = mask.values();
    const Index3& inner = mask.box().size;
    const auto row = static_cast<std::size_t>(inner[0]);
    parallelFor(static_cast<std::size_t>(size_[2]), 4, [&](std::size_t begin, std::size_t end) {
      for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
        std::fill(values_.data() + offset(0, 0, k), values_.data() + offset(0, 0, k + 1), std::uint8_t{0});
        for (int j = 0; j < inner[1] && k >= kPad && k < inner[2] + kPad; ++j) {
          const std::size_t from =
              row * (static_cast<std::size_t>(j) + static_cast<std::size_t>(inner[1]) * static_cast<std::size_t>(k - kPad));
          std::copy_n(source.data() + from, row, values_.data() + offset(kPad, j + kPad, k));
        }
      }
    });
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

  /// Outward gradients -grad S in index space of the voxels at, at + 1, ... by the 3x3x3 Sobel kernels, times 32 (exact integers).
  [[nodiscard]] Gradients outwardGradients(std::size_t at) const {
    const auto step = strides();
    Gradients gradients;
    for (int c = -1; c <= 1; ++c) {
      for (int b = -1; b <= 1; ++b) {
        const std::uint8_t* row = values_.data() + at + b * step[1] + c * step[2];
        const auto weightB = static_cast<std::int16_t>(2 - std::abs(b));
        const auto weightC = static_cast<std::int16_t>(2 - std::abs(c));
        for (std::size_t n = 0; n < kEight; ++n) {
          const auto low = static_cast<std::int16_t>(row[n - 1]);
          const auto high = static_cast<std::int16_t>(row[n + 1]);
          const auto smooth = static_cast<std::int16_t>(low + 2 * row[n] + high);
          gradients[0][n] = static_cast<std::int16_t>(gradients[0][n] + weightB * weightC * (low - high));
          gradients[1][n] = static_cast<std::int16_t>(gradients[1][n] - b * weightC * smooth);
          gradients[2][n] = static_cast<std::int16_t>(gradients[2][n] - c * weightB * smooth);
        }
      }
    }
    return gradients;
  }

  [[nodiscard]] std::array<std::ptrdiff_t, 3> strides() const {
    return {1, size_[0], static_cast<std::ptrdiff_t>(size_[0]) * size_[1]};
  }

 private:
  Index3 size_{};
  Index3 first_{};
  poisson::LargeArray<std::uint8_t> values_;
};

Vec3 toWorldDirection(const std::array<int, 3>& gradient, const ImageGeometry& geometry) {
  return geometry.direction *
         Vec3(gradient[0] / geometry.spacing[0], gradient[1] / geometry.spacing[1], gradient[2] / geometry.spacing[2]);
}

std::uint64_t eightBytes(const std::uint8_t* p) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, p, sizeof(bytes));
  return bytes;
}

/// How many voxels from `at` on, at most `left`, can have no `paper` point, looked at in eights: all outside, or inside with
/// neighbours that are all inside.
std::size_t withoutPaperPoint(const std::uint8_t* data, std::size_t at, std::size_t left,
                              const std::array<std::ptrdiff_t, 3>& step) {
  constexpr std::uint64_t kAllSet = 0x0101010101010101U;
  const auto deepInside = [&](const std::uint8_t* p) {
    std::uint64_t all = kAllSet;
    for (const std::ptrdiff_t row : {-step[2] - step[1], -step[2], -step[2] + step[1], -step[1], std::ptrdiff_t{0}, step[1],
                                     step[2] - step[1], step[2], step[2] + step[1]}) {
      all &= eightBytes(p + row - 1) & eightBytes(p + row + 1);
    }
    return all == kAllSet;
  };
  std::size_t n = 0;
  for (; n + kEight <= left; n += kEight) {
    const std::uint8_t* p = data + at + n;
    const std::uint64_t here = eightBytes(p);
    if (here != 0 && (here != kAllSet || !deepInside(p))) {
      break;
    }
  }
  return n;
}

/// The voxel centres of `paper` sampling in slice k of the padded grid.
void sampleSlicePaper(const PaddedMask& padded, const ImageGeometry& geometry, int k, OrientedPoints& out) {
  const auto step = padded.strides();
  const auto* data = padded.data();
  const int end = padded.size()[0] - 1;
  for (int j = 1; j + 1 < padded.size()[1]; ++j) {
    for (int i = 1; i < end; ++i) {
      i += static_cast<int>(withoutPaperPoint(data, padded.offset(i, j, k), static_cast<std::size_t>(end - i), step));
      const Gradients gradients = padded.outwardGradients(padded.offset(i, j, k));
      const std::size_t first = padded.offset(i, j, k);
      for (const int next = std::min(i + static_cast<int>(kEight), end); i < next; ++i) {
        const std::size_t at = padded.offset(i, j, k);
        const auto gradient = gradients.of(at - first);
        if (data[at] == 0 || gradient == std::array<int, 3>{}) {
          continue;
        }
        out.positions.push_back(geometry.toWorld(Vec3(i + padded.first()[0], j + padded.first()[1], k + padded.first()[2])));
        out.normals.push_back(toWorldDirection(gradient, geometry).normalized());
        out.weights.push_back(1.0);
      }
      --i;
    }
  }
}

/// The end of the run of voxels from `at` on, at most `left` long, that are like their neighbours after them along every axis.
std::size_t alikeFrom(const std::uint8_t* data, std::size_t at, std::size_t left, const std::array<std::ptrdiff_t, 3>& step) {
  std::size_t n = 0;
  for (; n + kEight <= left; n += kEight) {
    const std::uint8_t* p = data + at + n;
    const std::uint64_t here = eightBytes(p);
    if (((here ^ eightBytes(p + step[0])) | (here ^ eightBytes(p + step[1])) | (here ^ eightBytes(p + step[2]))) != 0) {
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
      i += static_cast<int>(alikeFrom(data, padded.offset(i, j, k), static_cast<std::size_t>(padded.size()[0] - 1 - i), step));
      if (i + 1 >= padded.size()[0]) {
        break;
      }
      const std::size_t first = padded.offset(i, j, k);
      const Gradients here = padded.outwardGradients(first);
      const std::array<Gradients, 3> beyond{padded.outwardGradients(first + 1),
                                            padded.outwardGradients(first + static_cast<std::size_t>(step[1])),
                                            padded.outwardGradients(first + static_cast<std::size_t>(step[2]))};
      for (const int next = std::min(i + static_cast<int>(kEight), padded.size()[0] - 1); i < next; ++i) {
        const std::size_t at = padded.offset(i, j, k);
        for (std::size_t a = 0; a < 3; ++a) {
          if (data[at] == data[at + static_cast<std::size_t>(step[a])]) {
            continue;
          }
          const auto axisOf = static_cast<Eigen::Index>(a);
          const Vec3 axis = geometry.direction.col(axisOf) * (data[at] != 0 ? 1.0 : -1.0);
          const auto low = here.of(at - first);
          const auto high = beyond[a].of(at - first);
          Vec3 normal = toWorldDirection({low[0] + high[0], low[1] + high[1], low[2] + high[2]}, geometry);
          const double length = normal.norm();
          // A vanishing or inward mean gradient (thin vessels) says nothing about the surface: the face itself does.
          normal = length > 0 && normal.dot(axis) > 0 ? Vec3(normal / length) : axis;
          Vec3 centre(i + padded.first()[0], j + padded.first()[1], k + padded.first()[2]);
          centre[axisOf] += 0.5;
          out.positions.push_back(geometry.toWorld(centre));
          out.normals.push_back(normal);
          out.weights.push_back(volume / geometry.spacing[axisOf] * normal.dot(axis));
          out.axes.push_back(static_cast<std::uint8_t>(a));
        }
      }
      --i;
    }
  }
}

/// All pieces' points, in the order of the pieces.
OrientedPoints joined(const std::vector<OrientedPoints>& pieces) {
  std::vector<std::size_t> first(pieces.size() + 1, 0);
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    first[n + 1] = first[n] + pieces[n].positions.size();
  }
  OrientedPoints all;
  all.positions.resize(first.back());
  all.normals.resize(first.back());
  all.weights.resize(first.back());
  all.axes.resize(std::any_of(pieces.begin(), pieces.end(), [](const auto& piece) { return !piece.axes.empty(); }) ? first.back()
                                                                                                                   : 0);
  parallelFor(pieces.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto to = static_cast<std::ptrdiff_t>(first[n]);
      std::copy(pieces[n].positions.begin(), pieces[n].positions.end(), all.positions.begin() + to);
      std::copy(pieces[n].normals.begin(), pieces[n].normals.end(), all.normals.begin() + to);
      std::copy(pieces[n].weights.begin(), pieces[n].weights.end(), all.weights.begin() + to);
      std::copy(pieces[n].axes.begin(), pieces[n].axes.end(), all.axes.begin() + to);
    }
  });
  return all;
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
  OrientedPoints points = joined(slices);
  if (points.positions.empty()) {  // voxels alone: the gradient at their centres is zero
    throw ReconstructionError("No voxel of the mask has a gradient, so paper sampling finds no surface; use unbiased sampling.");
  }
  return points;
}

OrientedPoints spreadOverFaces(const OrientedPoints& faces, const ImageGeometry& geometry, double cellMm,
                               const ExecutionContext& context) {
  Index3 parts{};
  for (std::size_t a = 0; a < 3; ++a) {
    parts[a] = std::max(1, static_cast<int>(std::ceil(geometry.spacing[static_cast<Eigen::Index>(a)] / cellMm - 0.01)));
  }
  if (parts == Index3{1, 1, 1}) {
    return faces;
  }
  constexpr std::size_t kPiece = 4096;
  std::vector<OrientedPoints> pieces((faces.positions.size() + kPiece - 1) / kPiece);
  parallelFor(pieces.size(), 1, [&](std::size_t piece, std::size_t) {
    context.throwIfCancelled();
    OrientedPoints& out = pieces[piece];
    for (std::size_t n = piece * kPiece; n < std::min(faces.positions.size(), (piece + 1) * kPiece); ++n) {
      const std::size_t u = (faces.axes[n] + 1U) % 3;
      const std::size_t v = (faces.axes[n] + 2U) % 3;
      const Vec3 alongU = geometry.direction.col(static_cast<Eigen::Index>(u)) * geometry.spacing[static_cast<Eigen::Index>(u)];
      const Vec3 alongV = geometry.direction.col(static_cast<Eigen::Index>(v)) * geometry.spacing[static_cast<Eigen::Index>(v)];
      for (int b = 0; b < parts[v]; ++b) {
        for (int a = 0; a < parts[u]; ++a) {
          out.positions.push_back(faces.positions[n] + ((a + 0.5) / parts[u] - 0.5) * alongU +
                                  ((b + 0.5) / parts[v] - 0.5) * alongV);
          out.normals.push_back(faces.normals[n]);
          out.weights.push_back(faces.weights[n] / (parts[u] * parts[v]));
          out.axes.push_back(faces.axes[n]);
        }
      }
    }
  });
  return joined(pieces);
}

}  // namespace glisson
