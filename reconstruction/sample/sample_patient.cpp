// Voxel centres decide the masks; 16 points a voxel (2 x 2 x 4) give partial volume and the truth's quadrature. A vessel of 3 mm
// stays connected at 2.5 mm slices: where its axis crosses the middle between two slices, both cut it in a disc of more than 1.6
// mm.
#include "reconstruction/sample/sample_patient.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "reconstruction/parallel.h"
#include "reconstruction/sample/vessel_tree.h"

namespace glisson {

namespace {

using namespace sample;

constexpr int kPointsPerVoxel = 16;
constexpr double kNoiseHounsfield = 10;

/// Hounsfield units in the portal venous phase.
constexpr int kLiverHu = 108;
constexpr int kPortalHu = 178;
constexpr int kHepaticHu = 170;
constexpr int kTumourHu = 62;
constexpr int kGallbladderHu = 10;

/// One body on the voxels near it: bit n of `points` says whether point n of the voxel is inside, `centre` whether its centre is.
struct Layer {
  IndexBox box;
  std::vector<std::uint16_t> points;
  std::vector<std::uint8_t> centre;

  explicit Layer(const IndexBox& where) : box(where), points(where.voxelCount()), centre(where.voxelCount()) {}
  [[nodiscard]] std::size_t rowOf(int j, int k) const {
    return static_cast<std::size_t>(box.size[0]) *
           (static_cast<std::size_t>(j - box.first[1]) +
            static_cast<std::size_t>(box.size[1]) * static_cast<std::size_t>(k - box.first[2]));
  }
  [[nodiscard]] bool hasRow(int j, int k) const {
    return j >= box.first[1] && j < box.first[1] + box.size[1] && k >= box.first[2] && k < box.first[2] + box.size[2];
  }
  [[nodiscard]] double volumeMl(const ImageGeometry& geometry) const {
    std::size_t inside = 0;
    for (const std::uint16_t bits : points) {
      inside += static_cast<std::size_t>(std::popcount(bits));
    }
    return static_cast<double>(inside) * geometry.voxelVolumeMm3() / kPointsPerVoxel * 1e-3;
  }
  [[nodiscard]] std::shared_ptr<const Mask> mask() const { return std::make_shared<const Mask>(box, centre); }
};

/// The grid: 384 x 288 in-plane, 200 mm from bottom to top.
ImageGeometry sampleGeometry(bool thin) {
  ImageGeometry geometry;
  geometry.size = {384, 288, thin ? 250 : 80};
  geometry.spacing = Vec3(0.78, 0.78, thin ? 0.8 : 2.5);
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * geometry.spacing[a] * (geometry.size[static_cast<std::size_t>(a)] - 1);
    // DICOM keeps six decimals: the origin has to be the same in every file.
    geometry.origin[a] = static_cast<double>(static_cast<long long>((kPatientShift[a] - half) * 1000.0)) / 1000.0;
  }
  return geometry;
}

Vec3 localPoint(const ImageGeometry& geometry, double i, double j, double k) {
  return {(geometry.origin[0] - kPatientShift[0]) + i * geometry.spacing[0],
          (geometry.origin[1] - kPatientShift[1]) + j * geometry.spacing[1],
          (geometry.origin[2] - kPatientShift[2]) + k * geometry.spacing[2]};
}

IndexBox boxAround(const ImageGeometry& geometry, const Vec3& low, const Vec3& high) {
  IndexBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a);
    const double start = geometry.origin[axis] - kPatientShift[axis];
    const int first = std::max(0, static_cast<int>(std::floor((low[axis] - start) / geometry.spacing[axis])) - 1);
    const int last = std::min(geometry.size[a] - 1, static_cast<int>(std::ceil((high[axis] - start) / geometry.spacing[axis])) + 1);
    box.first[a] = first;
    box.size[a] = std::max(0, last - first + 1);
  }
  return box;
}

IndexBox boxOf(const ImageGeometry& geometry, const Capsule& c) {
  const double r = std::max(c.fromRadius, c.toRadius);
  return boxAround(geometry, c.from.cwiseMin(c.to) - Vec3::Constant(r), c.from.cwiseMax(c.to) + Vec3::Constant(r));
}

/// Which of a voxel's points lie inside.
template <typename Distance>
unsigned pointsInside(const ImageGeometry& geometry, int i, int j, int k, unsigned known, const Distance& distance) {
  for (int s = 0; s < kPointsPerVoxel; ++s) {
    const double u = (s & 1) != 0 ? 0.25 : -0.25;
    const double v = (s & 2) != 0 ? 0.25 : -0.25;
    const double w = 0.25 * (s >> 2) - 0.375;
    const unsigned bit = 1U << static_cast<unsigned>(s);
    if ((known & bit) == 0 && distance(localPoint(geometry, i + u, j + v, k + w)) < 0) {
      known |= bit;
    }
  }
  return known;
}

/// Adds one body to the voxels of `part` in slice k.
template <typename Distance>
void addSlice(Layer& layer, const ImageGeometry& geometry, const IndexBox& part, int k, const Distance& distance) {
  const Vec3 reach = geometry.spacing.cwiseProduct(Vec3(0.25, 0.25, 0.375));
  const double band = 1.35 * length3(reach);  // beyond it all points of a voxel are on the side of its centre
  for (int j = part.first[1]; j < part.first[1] + part.size[1]; ++j) {
    const std::size_t row = layer.rowOf(j, k);
    for (int i = part.first[0]; i < part.first[0] + part.size[0]; ++i) {
      const double d = distance(localPoint(geometry, i, j, k));
      if (d > band) {
        continue;
      }
      const std::size_t n = row + static_cast<std::size_t>(i - layer.box.first[0]);
      const unsigned points = d < -band ? 0xFFFF : pointsInside(geometry, i, j, k, layer.points[n], distance);
      layer.points[n] = static_cast<std::uint16_t>(points);
      if (d < 0) {
        layer.centre[n] = 1;
      }
    }
  }
}

template <typename Distance>
Layer layerOf(const ImageGeometry& geometry, const IndexBox& box, const Distance& distance) {
  Layer layer(box);
  parallelFor(static_cast<std::size_t>(box.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      addSlice(layer, geometry, box, box.first[2] + static_cast<int>(k), distance);
    }
  });
  return layer;
}

Layer layerOf(const ImageGeometry& geometry, const VesselTree& tree) {
  std::vector<IndexBox> parts;
  IndexBox all;
  for (const Branch& branch : tree.branches) {
    parts.push_back(boxOf(geometry, branch.shape));
    all = enclosing(all, parts.back());
  }
  Layer layer(all);
  parallelFor(static_cast<std::size_t>(all.size[2]), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const int k = all.first[2] + static_cast<int>(n);
      for (std::size_t b = 0; b < parts.size(); ++b) {
        if (k >= parts[b].first[2] && k < parts[b].first[2] + parts[b].size[2]) {
          const Capsule& shape = tree.branches[b].shape;
          addSlice(layer, geometry, parts[b], k, [&](const Vec3& p) { return signedDistance(shape, p); });
        }
      }
    }
  });
  return layer;
}

/// About normal, from a hash of the voxel's number: the same on every machine and for any number of threads. Tenths of the unit.
int noiseOf(std::uint64_t voxel) {
  std::uint64_t z = voxel * 0x9E3779B97F4A7C15ULL + 0x632BE59BD9B4E019ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  int sum = 0;
  for (unsigned byte = 0; byte < 8; ++byte) {
    sum += static_cast<int>((z >> (8 * byte)) & 0xFFU);
  }
  constexpr double kSigmaOfSum = 209.0;  // eight bytes: sqrt(8 * (256^2 - 1) / 12)
  return static_cast<int>(std::floor((sum - 1020) * (kNoiseHounsfield / kSigmaOfSum) + 0.5));
}

/// Bodies in the order in which they win where they overlap.
using Tissues = std::vector<std::pair<const Layer*, int>>;

/// One row of the CT: the tissues' mean over each voxel's points, and noise.
void fillRow(std::span<std::int16_t> row, std::span<const BackgroundColumn> columns, const ImageGeometry& geometry,
             const Tissues& tissues, int j, int k) {
  const double z = localPoint(geometry, 0, j, k)[2];
  const auto firstVoxel =
      static_cast<std::uint64_t>(geometry.size[0]) *
      (static_cast<std::uint64_t>(j) + static_cast<std::uint64_t>(geometry.size[1]) * static_cast<std::uint64_t>(k));
  std::vector<std::pair<const Layer*, int>> here;
  std::copy_if(tissues.begin(), tissues.end(), std::back_inserter(here), [&](const auto& t) { return t.first->hasRow(j, k); });
  for (int i = 0; i < geometry.size[0]; ++i) {
    unsigned left = 0xFFFF;
    int sum = 0;
    for (const auto& [layer, hu] : here) {
      const int x = i - layer->box.first[0];
      if (x >= 0 && x < layer->box.size[0]) {
        const unsigned inside = layer->points[layer->rowOf(j, k) + static_cast<std::size_t>(x)] & left;
        sum += std::popcount(inside) * hu;
        left &= ~inside;
      }
    }
    const auto n = static_cast<std::size_t>(i);
    if (left != 0) {
      sum += std::popcount(left) * static_cast<int>(std::floor(columns[n].hounsfield(z) + 0.5));
    }
    const int mean = static_cast<int>(std::floor(static_cast<double>(sum) / kPointsPerVoxel + 0.5));
    row[n] = static_cast<std::int16_t>(std::clamp(mean + noiseOf(firstVoxel + n), -1024, 3071));
  }
}

std::vector<std::int16_t> imageOf(const ImageGeometry& geometry, const Tissues& tissues, const ExecutionContext& context) {
  std::vector<std::int16_t> image(geometry.voxelCount());
  const auto width = static_cast<std::size_t>(geometry.size[0]);
  parallelFor(static_cast<std::size_t>(geometry.size[1]), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      context.throwIfCancelled();
      std::vector<BackgroundColumn> columns;
      for (int i = 0; i < geometry.size[0]; ++i) {
        const Vec3 p = localPoint(geometry, i, static_cast<double>(j), 0);
        columns.emplace_back(p[0], p[1]);
      }
      for (int k = 0; k < geometry.size[2]; ++k) {
        const std::size_t start = width * (j + static_cast<std::size_t>(geometry.size[1]) * static_cast<std::size_t>(k));
        fillRow(std::span(image).subspan(start, width), columns, geometry, tissues, static_cast<int>(j), k);
      }
    }
  });
  return image;
}

LabelledMask labelled(const std::string& name, int label, StructureKind kind, const Layer& layer) {
  LabelledMask mask;
  mask.name = name;
  mask.label = label;
  mask.kind = kind;
  mask.colour = defaultColour(kind);
  mask.mask = layer.mask();
  return mask;
}

PatientIdentity sampleIdentity(bool thin) {
  PatientIdentity identity;
  identity.patientName = "Glisson^Sample";
  identity.patientId = "GLISSON-SAMPLE";
  identity.birthDate = "19700101";
  identity.studyDate = "20200101";
  identity.seriesDescription = thin ? "Synthetic portal venous phase, thin" : "Synthetic portal venous phase";
  // 2.25. and a number of the UUID kind (PS3.5 B.2), fixed for good.
  identity.frameOfReferenceUid =
      thin ? "2.25.210436587402178553316470318264990174602" : "2.25.210436587402178553316470318264990174601";
  return identity;
}

std::vector<Vec3> inWorld(const std::vector<Vec3>& local) {
  std::vector<Vec3> world;
  world.reserve(local.size());
  for (const Vec3& p : local) {
    world.emplace_back(p + kPatientShift);
  }
  return world;
}

}  // namespace

SamplePatient makeSamplePatient(bool thin, const ExecutionContext& context) {
  SamplePatient patient;
  const ImageGeometry geometry = sampleGeometry(thin);
  context.report(0.0, "vessels");
  const VesselTrees trees = growVessels(thin ? 1.0 : 1.5);
  const Layer portal = layerOf(geometry, trees.portal);
  const Layer hepatic = layerOf(geometry, trees.hepatic);
  context.report(0.2, "liver");
  const Layer liver = layerOf(geometry, boxAround(geometry, Vec3(-130, -85, -78), Vec3(100, 80, 85)), liverDistance);
  const Layer gallbladder = layerOf(geometry, boxAround(geometry, Vec3(-62, -60, -82), Vec3(-18, 14, -34)), gallbladderDistance);
  std::vector<Layer> lesions;
  for (const Ellipsoid& body : tumours()) {
    lesions.push_back(layerOf(geometry, boxAround(geometry, body.centre - body.radii, body.centre + body.radii),
                              [&](const Vec3& p) { return signedDistance(body, p); }));
  }
  context.report(0.5, "CT");

  Tissues tissues;
  for (const Layer& lesion : lesions) {
    tissues.emplace_back(&lesion, kTumourHu);
  }
  tissues.insert(tissues.end(), {{&portal, kPortalHu}, {&hepatic, kHepaticHu}, {&liver, kLiverHu}, {&gallbladder, kGallbladderHu}});
  patient.ct.geometry = geometry;
  patient.ct.hounsfield = imageOf(geometry, tissues, context);
  patient.ct.identity = sampleIdentity(thin);
  patient.ct.source = kSampleSource;

  Segmentation& segmentation = patient.segmentation;
  segmentation.geometry = geometry;
  segmentation.source = kSampleSource;
  segmentation.patientId = patient.ct.identity.patientId;
  segmentation.frameOfReferenceUid = patient.ct.identity.frameOfReferenceUid;
  segmentation.structures = {labelled("liver", 1, StructureKind::Liver, liver),
                             labelled("portal vein", 2, StructureKind::PortalVein, portal),
                             labelled("hepatic vein", 3, StructureKind::HepaticVein, hepatic),
                             labelled("gallbladder", 4, StructureKind::Gallbladder, gallbladder)};
  SampleTruth& truth = patient.truth;
  for (std::size_t n = 0; n < lesions.size(); ++n) {
    segmentation.structures.push_back(
        labelled("tumour " + std::to_string(n + 1), 5 + static_cast<int>(n), StructureKind::Tumour, lesions[n]));
    constexpr double kPi = 3.14159265358979323846;
    const Vec3& r = tumours()[n].radii;
    truth.tumourMl.push_back(4.0 / 3.0 * kPi * r[0] * r[1] * r[2] * 1e-3);
  }
  truth.liverMl = liver.volumeMl(geometry);
  truth.portalVeinMl = portal.volumeMl(geometry);
  truth.hepaticVeinMl = hepatic.volumeMl(geometry);
  truth.gallbladderMl = gallbladder.volumeMl(geometry);
  truth.portalBranchPoints = inWorld(trees.portal.branchPoints());
  truth.hepaticBranchPoints = inWorld(trees.hepatic.branchPoints());
  context.report(1.0, "sample patient");
  return patient;
}

}  // namespace glisson
