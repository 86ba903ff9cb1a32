// Label maps and .seg.nrrd layers to masks.

#include <algorithm>
#include <cmath>
#include <limits>

#include "reconstruction/errors.h"
#include "reconstruction/image/label_tables.h"
#include "reconstruction/io/import/values.h"
#include "reconstruction/text.h"

namespace glisson::import {

namespace {
constexpr std::size_t kMostLabels = 1024;

template <typename T>
std::vector<std::int32_t> layerLabels(const std::string& name, const ImageFile& file, int layer) {
  const std::size_t voxels = file.geometry.voxelCount();
  const auto step = static_cast<std::size_t>(file.layers);
  const auto first = static_cast<std::size_t>(layer);
  const bool plain = file.slope == 1 && file.intercept == 0;
  std::vector<std::int32_t> labels(voxels);
  for (std::size_t n = 0; n < voxels; ++n) {
    const T raw = valueAt<T>(file.bytes, first + n * step);
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      if (plain) {
        labels[n] = raw;
        continue;
      }
    }
    const double value = static_cast<double>(raw) * file.slope + file.intercept;
    const double whole = std::round(value);
    if (!(std::abs(value - whole) <= 1e-4)) {
      throw InputError(name + " holds values that are not whole numbers, so it is an image and not a label map; open it as a CT.");
    }
    if (whole < 0 || whole > std::numeric_limits<std::int32_t>::max()) {
      throw InputError(name + " holds values such as " + formatNumber(whole, 0) +
                       ", so it is an image and not a label map; open it as a CT.");
    }
    labels[n] = static_cast<std::int32_t>(whole);
  }
  return labels;
}

std::vector<std::int32_t> labelsOf(const std::string& name, const ImageFile& file, int layer) {
  return withType(file.scalar, [&](auto type) { return layerLabels<decltype(type)>(name, file, layer); });
}

struct Box {
  Index3 low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
  Index3 high{-1, -1, -1};
  void addRun(int from, int to, int j, int k) {
    low = {std::min(low[0], from), std::min(low[1], j), std::min(low[2], k)};
    high = {std::max(high[0], to), std::max(high[1], j), std::max(high[2], k)};
  }
};

/// The box of every non-zero label, found run by run.
std::map<int, Box> boxesOf(const std::string& name, const std::vector<std::int32_t>& labels, const Index3& size) {
  std::map<int, Box> boxes;
  const auto row = static_cast<std::size_t>(size[0]);
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      const std::int32_t* line =
          labels.data() + row * (static_cast<std::size_t>(j) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
      for (int i = 0; i < size[0];) {
        const int from = i;
        while (i < size[0] && line[i] == line[from]) {
          ++i;
        }
        if (line[from] != 0) {
          boxes[line[from]].addRun(from, i - 1, j, k);
          if (boxes.size() > kMostLabels) {
            throw InputError(name + " holds more than " + std::to_string(kMostLabels) +
                             " values, so it is an image and not a label map; open it as a CT.");
          }
        }
      }
    }
  }
  return boxes;
}

/// The voxels of `label` (or, without one, every non-zero voxel) within a box.
std::shared_ptr<const Mask> cut(const std::vector<std::int32_t>& labels, const Index3& size, const Box& box,
                                std::optional<int> label) {
  if (box.high[0] < 0) {
    return std::make_shared<const Mask>();
  }
  IndexBox where{box.low, {box.high[0] - box.low[0] + 1, box.high[1] - box.low[1] + 1, box.high[2] - box.low[2] + 1}};
  std::vector<std::uint8_t> values;
  values.reserve(where.voxelCount());
  for (int k = box.low[2]; k <= box.high[2]; ++k) {
    for (int j = box.low[1]; j <= box.high[1]; ++j) {
      const std::size_t row = static_cast<std::size_t>(size[0]) *
                              (static_cast<std::size_t>(j) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(k));
      for (int i = box.low[0]; i <= box.high[0]; ++i) {
        const std::int32_t value = labels[row + static_cast<std::size_t>(i)];
        values.push_back((label ? value == *label : value != 0) ? 1 : 0);
      }
    }
  }
  return std::make_shared<const Mask>(where, values);
}

Box unionOfBoxes(const std::map<int, Box>& boxes) {
  Box all;
  for (const auto& [label, box] : boxes) {
    all.addRun(box.low[0], box.high[0], box.low[1], box.low[2]);
    all.addRun(box.low[0], box.high[0], box.high[1], box.high[2]);
  }
  return all;
}

LabelledMask unnamed(int label, const ImageFile& file, const std::map<int, std::string>& table, const ReadOptions& options) {
  LabelledMask structure;
  structure.label = label;
  structure.name = "label " + std::to_string(label);
  if (const auto known = table.find(label); known != table.end()) {
    structure.name = known->second;
  } else if (const auto embedded = file.labelNames.find(label); table.empty() && embedded != file.labelNames.end()) {
    structure.name = embedded->second;
  }
  structure.kind = kindOfName(structure.name, options);
  if (const auto chosen = options.kindByLabel.find(label); chosen != options.kindByLabel.end()) {
    structure.kind = chosen->second;
  }
  return structure;
}

/// The structures of one layer: its segments in the file's order, then labels that no segment names.
void addLayer(const std::string& name, const ImageFile& file, int layer, const ReadOptions& options, Segmentation& result) {
  const std::vector<std::int32_t> labels = labelsOf(name, file, layer);
  const Index3& size = file.geometry.size;
  std::map<int, Box> boxes = boxesOf(name, labels, size);
  for (const Segment& segment : file.segments) {
    if (segment.layer != layer) {
      continue;
    }
    LabelledMask structure;
    structure.name = segment.name;
    structure.label = segment.label.value_or(1);
    structure.colour = segment.colour;
    structure.kind = kindOfName(segment.name, options);
    if (const auto chosen = options.kindByLabel.find(structure.label); file.layers == 1 && chosen != options.kindByLabel.end()) {
      structure.kind = chosen->second;
    }
    const auto box = segment.label ? boxes.find(*segment.label) : boxes.end();
    if (segment.label) {
      structure.mask = box == boxes.end() ? std::make_shared<const Mask>() : cut(labels, size, box->second, segment.label);
    } else {
      structure.mask = cut(labels, size, unionOfBoxes(boxes), std::nullopt);
      boxes.clear();
    }
    if (box != boxes.end()) {
      boxes.erase(box);
    }
    result.structures.push_back(std::move(structure));
  }
  const auto table = labelTableNames(options.labelTable);
  for (const auto& [label, box] : boxes) {
    LabelledMask structure = unnamed(label, file, table, options);
    if (file.layers > 1) {
      structure.name += " of layer " + std::to_string(layer);
    }
    structure.mask = cut(labels, size, box, label);
    result.structures.push_back(std::move(structure));
  }
}
}  // namespace

std::optional<StructureKind> kindOfName(const std::string& name, const ReadOptions& options) {
  for (const auto& [chosen, kind] : options.kindByName) {
    if (toLower(chosen) == toLower(name)) {
      return kind;
    }
  }
  return recogniseKind(name);
}

std::vector<std::string> namesOf(const Segmentation& segmentation) {
  std::vector<std::string> names;
  std::ranges::transform(segmentation.structures, std::back_inserter(names), &LabelledMask::name);
  return names;
}

void requireChosen(const std::string& name, const std::vector<std::string>& names, const std::set<int>& numbers,
                   const ReadOptions& options) {
  constexpr std::size_t kMostNamed = 12;
  const auto listed = [](const auto& items, auto text) {
    std::string list;
    std::size_t count = 0;
    for (const auto& item : items) {
      list += (count == 0 ? "" : ", ") + (count < kMostNamed ? text(item) : std::string("..."));
      if (++count > kMostNamed) {
        break;
      }
    }
    return list;
  };
  const std::string held = listed(names, [](const std::string& text) { return text; });
  for (const auto& [label, kind] : options.kindByLabel) {
    if (!numbers.contains(label)) {
      throw InputError(name + " holds no label " + std::to_string(label) + " to which --labels could give a kind; " +
                       (numbers.empty() ? "its structures go by name (NAME=KIND): " + held
                                        : "its labels are " + listed(numbers, [](int number) { return std::to_string(number); })) +
                       ".");
    }
  }
  for (const auto& choice : options.kindByName) {
    const std::string& chosen = choice.first;
    if (std::ranges::none_of(names, [&](const std::string& known) { return toLower(known) == toLower(chosen); })) {
      throw InputError(name + " holds no structure named \"" + chosen + "\" to which --labels could give a kind; it holds " + held +
                       ".");
    }
  }
}

void checkLabels(const std::string& name, Segmentation& segmentation) {
  bool any = false;
  for (const LabelledMask& structure : segmentation.structures) {
    any = any || (structure.mask && !structure.mask->empty());
    if (structure.mask && structure.mask->empty()) {
      segmentation.notes.push_back("\"" + structure.name + "\" is empty: no voxel is set.");
    }
  }
  const bool onlyOthers = !segmentation.structures.empty() &&
                          std::ranges::none_of(segmentation.structures, [](const LabelledMask& s) { return s.mask != nullptr; });
  if (!any && !onlyOthers) {
    throw InputError(name + " holds no label: no voxel is set; choose the file with the segmentation.");
  }
}

Segmentation toSegmentation(const std::filesystem::path& path, ImageFile&& file, const ReadOptions& options) {
  const std::string name = path.string();
  Segmentation result;
  result.geometry = file.geometry;
  result.source = name;
  result.notes = file.notes;
  for (int layer = 0; layer < file.layers; ++layer) {
    addLayer(name, file, layer, options, result);
  }
  // In a file of layers the numbers of segments repeat from layer to layer: only their names tell them apart.
  std::set<int> numbers;
  for (const LabelledMask& structure : result.structures) {
    if (file.layers == 1 || std::ranges::find(file.segments, structure.name, &Segment::name) == file.segments.end()) {
      numbers.insert(structure.label);
    }
  }
  std::vector<std::string> names = namesOf(result);
  if (names.size() == 1 && file.segments.empty()) {
    names.push_back(stemOf(path));
  }
  if (!names.empty()) {  // else the refusal of an empty file says more
    requireChosen(name, names, numbers, options);
  }
  // Back from layer by layer to the file's order; labels without a segment stay behind.
  const auto rank = [&](const LabelledMask& structure) {
    return std::ranges::find(file.segments, structure.name, &Segment::name) - file.segments.begin();
  };
  std::ranges::stable_sort(result.structures, {}, rank);
  // A file that holds one organ and is named after it.
  if (result.structures.size() == 1 && file.segments.empty() && result.structures[0].name.starts_with("label ")) {
    LabelledMask& only = result.structures[0];
    if (const auto kind = kindOfName(stemOf(path), options)) {
      only.name = stemOf(path);
      only.kind = only.kind ? only.kind : kind;
    }
  }
  checkLabels(name, result);
  return result;
}

Mask toOneMask(const std::filesystem::path& path, ImageFile&& file) {
  const std::string name = path.string();
  if (file.layers != 1) {
    throw InputError(name + " holds several layers; a folder of masks holds one organ per file, so open this file by itself.");
  }
  const std::vector<std::int32_t> labels = labelsOf(name, file, 0);
  const std::map<int, Box> boxes = boxesOf(name, labels, file.geometry.size);
  if (boxes.size() > 1) {
    throw InputError(name + " holds " + std::to_string(boxes.size()) +
                     " labels; a folder of masks holds one organ per file, so open this file by itself.");
  }
  return boxes.empty() ? Mask() : *cut(labels, file.geometry.size, boxes.begin()->second, std::nullopt);
}

}  // namespace glisson::import
