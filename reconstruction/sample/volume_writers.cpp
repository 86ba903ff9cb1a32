// NIfTI-1: nifti1.h of the NIfTI Data Format Working Group. NRRD0004: teem.sourceforge.net/nrrd/format.html; the Segment fields
// are those 3D Slicer writes.
#include "reconstruction/sample/volume_writers.h"

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <string>

#include "reconstruction/sample/gzip_file.h"
#include "reconstruction/text.h"

namespace glisson::sample {

namespace {

static_assert(std::endian::native == std::endian::little, "the writers put numbers down as they lie in memory");

constexpr std::size_t kNiftiData = 352;

template <typename T>
void put(std::array<std::byte, kNiftiData>& header, std::size_t at, T value) {
  std::memcpy(header.data() + at, &value, sizeof value);
}

std::array<std::byte, kNiftiData> niftiHeader(const ImageGeometry& geometry, std::int16_t type, std::int16_t bits) {
  if (!geometry.direction.isIdentity(0)) {
    throw std::invalid_argument("writeNifti: only straight grids");
  }
  std::array<std::byte, kNiftiData> header{};
  put(header, 0, std::int32_t{348});
  put(header, 40, std::int16_t{3});
  for (std::size_t a = 0; a < 3; ++a) {
    put(header, 42 + 2 * a, static_cast<std::int16_t>(geometry.size[a]));
    put(header, 80 + 4 * a, static_cast<float>(geometry.spacing[static_cast<int>(a)]));
  }
  for (std::size_t a = 3; a < 7; ++a) {
    put(header, 42 + 2 * a, std::int16_t{1});
  }
  put(header, 70, type);
  put(header, 72, bits);
  put(header, 76, 1.0F);  // qfac: diag(-1,-1,1) turns, it does not mirror
  put(header, 108, static_cast<float>(kNiftiData));
  put(header, 112, 1.0F);             // slope
  header[123] = std::byte{2};         // mm
  put(header, 252, std::int16_t{1});  // qform, sform: scanner
  put(header, 254, std::int16_t{1});
  put(header, 264, 1.0F);  // quaternion d: half a turn about z, LPS to RAS
  const Vec3 ras(-geometry.origin[0], -geometry.origin[1], geometry.origin[2]);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<int>(a);
    put(header, 268 + 4 * a, static_cast<float>(ras[axis]));
    put(header, 280 + 16 * a + 4 * a, static_cast<float>((a < 2 ? -1 : 1) * geometry.spacing[axis]));
    put(header, 280 + 16 * a + 12, static_cast<float>(ras[axis]));
  }
  std::memcpy(header.data() + 344, "n+1", 4);
  return header;
}

void writeNiftiBytes(const std::filesystem::path& file, const std::array<std::byte, kNiftiData>& header,
                     std::span<const std::byte> values) {
  std::vector<std::byte> content(header.begin(), header.end());
  content.insert(content.end(), values.begin(), values.end());
  writeFile(file, gzip(content, 4));
}

std::string vectorText(const Vec3& v) { return "(" + formatExact(v[0]) + "," + formatExact(v[1]) + "," + formatExact(v[2]) + ")"; }

bool overlap(const Mask& a, const Mask& b) { return !intersectionOf(a, b).empty(); }

/// The first layer of each structure in which nothing placed before overlaps it.
std::vector<std::size_t> layersOf(const Segmentation& segmentation, std::size_t& count) {
  std::vector<Mask> layers;
  std::vector<std::size_t> of;
  for (const LabelledMask& structure : segmentation.structures) {
    std::size_t layer = 0;
    while (layer < layers.size() && overlap(layers[layer], *structure.mask)) {
      ++layer;
    }
    if (layer == layers.size()) {
      layers.emplace_back();
    }
    layers[layer] = unionOf(layers[layer], *structure.mask);
    of.push_back(layer);
  }
  count = layers.size();
  return of;
}

/// The DICOM code of a kind (clinical.md's table), in the words of 3D Slicer's terminology.
std::string terminologyOf(StructureKind kind) {
  const auto anatomy = [](const std::string& code) { return "SCT^123037004^Anatomical Structure~SCT^" + code; };
  std::string entry;
  switch (kind) {
    case StructureKind::Liver:
      entry = anatomy("10200004^Liver");
      break;
    case StructureKind::PortalVein:
      entry = anatomy("32764006^Portal vein");
      break;
    case StructureKind::HepaticVein:
      entry = anatomy("8993003^Hepatic vein");
      break;
    case StructureKind::Gallbladder:
      entry = anatomy("28231008^Gallbladder");
      break;
    case StructureKind::Tumour:
      entry = "SCT^49755003^Morphologically Altered Structure~SCT^4147007^Mass";
      break;
    default:
      return "";
  }
  return "TerminologyEntry:Segmentation category and type - 3D Slicer General Anatomy list~" + entry +
         "~^^~Anatomic codes - DICOM master list~^^~^^|";
}

std::string segmentFields(const LabelledMask& structure, std::size_t number, std::size_t layer) {
  const std::string key = "Segment" + std::to_string(number) + "_";
  const Rgb colour = structure.colour.value_or(Rgb{128, 128, 128});
  const auto share = [](std::uint8_t c) { return formatNumber(c / 255.0, 6); };
  const IndexBox& box = structure.mask->box();
  std::string extent;
  for (std::size_t a = 0; a < 3; ++a) {
    extent += (a > 0 ? " " : "") + std::to_string(box.first[a]) + " " + std::to_string(box.first[a] + box.size[a] - 1);
  }
  return key + "Color:=" + share(colour.r) + " " + share(colour.g) + " " + share(colour.b) + "\n" +  //
         key + "ColorAutoGenerated:=0\n" +                                                           //
         key + "Extent:=" + extent + "\n" +                                                          //
         key + "ID:=Segment_" + std::to_string(number + 1) + "\n" +                                  //
         key + "LabelValue:=" + std::to_string(structure.label) + "\n" +                             //
         key + "Layer:=" + std::to_string(layer) + "\n" +                                            //
         key + "Name:=" + structure.name + "\n" +                                                    //
         key + "NameAutoGenerated:=0\n" +                                                            //
         key + "Tags:=" + (structure.kind ? terminologyOf(*structure.kind) : "") + "\n";
}

/// Calls place(offset in the grid) for every voxel of the mask.
template <typename Place>
void forEachVoxel(const Mask& mask, const Index3& size, const Place& place) {
  const IndexBox& box = mask.box();
  std::size_t n = 0;
  for (int k = 0; k < box.size[2]; ++k) {
    for (int j = 0; j < box.size[1]; ++j) {
      const std::size_t row =
          static_cast<std::size_t>(box.first[0]) +
          static_cast<std::size_t>(size[0]) * (static_cast<std::size_t>(box.first[1] + j) +
                                               static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(box.first[2] + k));
      for (int i = 0; i < box.size[0]; ++i, ++n) {
        if (mask.values()[n] != 0) {
          place(row + static_cast<std::size_t>(i));
        }
      }
    }
  }
}

}  // namespace

void writeNifti(const std::filesystem::path& file, const ImageGeometry& geometry, std::span<const std::int16_t> values) {
  writeNiftiBytes(file, niftiHeader(geometry, 4, 16), std::as_bytes(values));
}

void writeNifti(const std::filesystem::path& file, const ImageGeometry& geometry, std::span<const std::uint8_t> values) {
  writeNiftiBytes(file, niftiHeader(geometry, 2, 8), std::as_bytes(values));
}

std::vector<std::uint8_t> exclusiveLabels(const Segmentation& segmentation) {
  std::vector<std::uint8_t> labels(segmentation.geometry.voxelCount());
  for (const LabelledMask& structure : segmentation.structures) {
    const auto label = static_cast<std::uint8_t>(structure.label);
    forEachVoxel(*structure.mask, segmentation.geometry.size, [&](std::size_t voxel) { labels[voxel] = label; });
  }
  return labels;
}

void writeSegNrrd(const std::filesystem::path& file, const Segmentation& segmentation) {
  const ImageGeometry& geometry = segmentation.geometry;
  std::size_t layers = 0;
  const std::vector<std::size_t> layerOf = layersOf(segmentation, layers);
  const Mat3 steps = geometry.indexToWorldMatrix();
  std::string head = "NRRD0004\n# Complete NRRD file format specification at:\n# http://teem.sourceforge.net/nrrd/format.html\n";
  head += "type: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: " + std::to_string(layers);
  for (const int n : geometry.size) {
    head += " " + std::to_string(n);
  }
  head += "\nspace directions: none " + vectorText(steps.col(0)) + " " + vectorText(steps.col(1)) + " " + vectorText(steps.col(2));
  head += "\nkinds: list domain domain domain\nencoding: gzip\nspace origin: " + vectorText(geometry.origin) + "\n";
  for (std::size_t n = 0; n < segmentation.structures.size(); ++n) {
    head += segmentFields(segmentation.structures[n], n, layerOf[n]);
  }
  head += "Segmentation_ContainedRepresentationNames:=Binary labelmap|\nSegmentation_ConversionParameters:=\n";
  head += "Segmentation_MasterRepresentation:=Binary labelmap\nSegmentation_ReferenceImageExtentOffset:=0 0 0\n\n";

  std::vector<std::uint8_t> values(layers * geometry.voxelCount());
  for (std::size_t n = 0; n < segmentation.structures.size(); ++n) {
    const auto label = static_cast<std::uint8_t>(segmentation.structures[n].label);
    forEachVoxel(*segmentation.structures[n].mask, geometry.size,
                 [&](std::size_t voxel) { values[voxel * layers + layerOf[n]] = label; });
  }
  writeFile(file, bytesOf(head), gzip(std::as_bytes(std::span(values)), 6));
}

}  // namespace glisson::sample
