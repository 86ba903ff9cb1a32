#include "planning/storage/embedded_ct.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "planning/storage/case_json.h"
#include "planning/storage/database.h"
#include "planning/storage/packing.h"
#include "planning/storage/sha256.h"
#include "planning/storage/table_access.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

namespace {

constexpr double kLargestBytes = 4.0 * (1 << 30);
constexpr std::size_t kPartBytes = std::size_t{4} << 20;  ///< of voxels, where a slice is not larger
constexpr std::size_t kGroup = 8;                         ///< parts packed at once
constexpr std::size_t kMostGain = 1032;                   ///< of zlib

std::size_t sliceVoxels(const ImageGeometry& geometry) {
  return static_cast<std::size_t>(geometry.size[0]) * static_cast<std::size_t>(geometry.size[1]);
}

std::size_t mostSlicesPerPart(const ImageGeometry& geometry) {
  return std::max<std::size_t>(1, kPartBytes / (2 * sliceVoxels(geometry)));
}

bool isTooLarge(const ImageGeometry& geometry) {
  return 2.0 * geometry.size[0] * geometry.size[1] * geometry.size[2] > kLargestBytes;
}

std::string keyOf(std::size_t part) { return "ct/" + std::to_string(part); }

std::string hashOf(std::span<const std::int16_t> voxels) { return sha256Hex(std::as_bytes(voxels)); }

struct Layout {
  ImageGeometry geometry;
  std::size_t slices = 1;           ///< per part; the last may hold fewer
  std::vector<std::string> hashes;  ///< of each part

  [[nodiscard]] std::size_t first(std::size_t part) const { return part * slices * sliceVoxels(geometry); }
  [[nodiscard]] std::size_t count(std::size_t part) const { return std::min(first(part + 1), geometry.voxelCount()) - first(part); }
};

std::size_t partsOf(const ImageGeometry& geometry, std::size_t slices) {
  return (static_cast<std::size_t>(geometry.size[2]) + slices - 1) / slices;
}

/// Everything but the voxels, proven to fit together and to be held by the parts that are there.
Layout readLayout(const Database& database, const ImageGeometry& labels) {
  const Json json = Json::parse(caseTables::documentText(database, "ct"));
  Layout layout;
  layout.geometry = caseJson::toGeometry(json.at("geometry"));
  layout.slices = json.at("slicesPerPart").get<std::size_t>();
  layout.hashes = json.at("sha256").get<std::vector<std::string>>();
  if (isTooLarge(layout.geometry) || layout.slices < 1 || layout.slices > static_cast<std::size_t>(layout.geometry.size[2]) ||
      layout.slices > mostSlicesPerPart(layout.geometry) || layout.hashes.size() != partsOf(layout.geometry, layout.slices)) {
    throw std::runtime_error("its size is impossible");
  }
  if (!(labels.cornerDistance(layout.geometry) <= kSameGridMm) || labels.size != layout.geometry.size) {
    throw std::runtime_error("it does not lie on the grid of the labels");
  }
  const std::int64_t packed = database.number("SELECT sum(length(data)) FROM part WHERE key GLOB 'ct/*'");
  if (static_cast<double>(layout.geometry.voxelCount()) * 2 / kMostGain > static_cast<double>(packed) + 64.0) {
    throw std::runtime_error("a part claims more bytes than it can hold");
  }
  return layout;
}

/// Unpacks the parts [begin, end) into `voxels`, each proven by its hash.
void readGroup(const Database& database, const Layout& layout, std::size_t begin, std::size_t end,
               std::vector<std::int16_t>& voxels) {
  std::vector<std::vector<std::byte>> packed;
  for (std::size_t part = begin; part < end; ++part) {
    Statement statement(database, "SELECT data FROM part WHERE key = ?");
    if (!statement.bind(0, std::string_view(keyOf(part))).step()) {
      throw std::runtime_error("its " + keyOf(part) + " is missing");
    }
    const std::span<const std::byte> data = statement.bytes(0);
    packed.emplace_back(data.begin(), data.end());
  }
  parallelFor(end - begin, 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t n = from; n < to; ++n) {
      const std::size_t part = begin + n;
      const std::vector<std::int16_t> values = unpackVoxels(packed[n], layout.count(part));
      if (hashOf(values) != layout.hashes[part]) {
        throw std::runtime_error("its voxels do not match their SHA-256");
      }
      std::copy(values.begin(), values.end(), voxels.begin() + static_cast<std::ptrdiff_t>(layout.first(part)));
    }
  });
}

[[noreturn]] void damagedCt(const Database& database, const std::string& what) {
  throw InputError(database.path().string() + " holds an embedded CT that is damaged (" + what +
                   ") and not shown; the rest of the case is whole, ask for the file again to see the slices.");
}
}  // namespace

std::uint64_t embeddedCtBytes(const CtVolume& ct) {
  constexpr std::size_t kProbes = 4;
  const std::size_t slice = sliceVoxels(ct.geometry);
  const auto slices = static_cast<std::size_t>(ct.geometry.size[2]);
  std::size_t probed = 0;
  std::size_t packed = 0;
  for (std::size_t n = 0; n < kProbes; ++n) {
    const std::size_t k = (2 * n + 1) * slices / (2 * kProbes);
    packed += packVoxels(std::span(ct.hounsfield).subspan(k * slice, slice)).data.size();
    probed += slice;
  }
  return static_cast<std::uint64_t>(static_cast<double>(packed) * static_cast<double>(ct.hounsfield.size()) /
                                    static_cast<double>(probed));
}

namespace caseTables {

bool hasEmbeddedCt(const Database& database) { return hasDocument(database, "ct"); }

void writeEmbeddedCt(const Database& database, const CtVolume& ct, const ExecutionContext& context) {
  if (isTooLarge(ct.geometry)) {
    throw InputError(ct.source + " is larger than 4 GiB and cannot be embedded in a case; send its files beside the case.");
  }
  Layout layout{ct.geometry, mostSlicesPerPart(ct.geometry), {}};
  layout.slices = std::min(layout.slices, static_cast<std::size_t>(ct.geometry.size[2]));
  const std::size_t parts = partsOf(ct.geometry, layout.slices);
  layout.hashes.resize(parts);
  for (std::size_t begin = 0; begin < parts; begin += kGroup) {
    context.report(static_cast<double>(begin) / static_cast<double>(parts), "Writing");
    std::vector<Packed> packed(std::min(kGroup, parts - begin));
    parallelFor(packed.size(), 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t n = from; n < to; ++n) {
        const auto voxels = std::span(ct.hounsfield).subspan(layout.first(begin + n), layout.count(begin + n));
        layout.hashes[begin + n] = hashOf(voxels);
        packed[n] = packVoxels(voxels);
      }
    });
    for (std::size_t n = 0; n < packed.size(); ++n) {
      putPart(database, keyOf(begin + n), packed[n]);
    }
  }
  Json json;
  json["geometry"] = caseJson::fromGeometry(ct.geometry);
  json["slicesPerPart"] = layout.slices;
  json["sha256"] = layout.hashes;
  putDocument(database, "ct", textOf(json));
}

void copyEmbeddedCt(const Database& from, const Database& to) {
  Statement document(from, "SELECT json, crc FROM document WHERE key = 'ct'");
  if (!document.step()) {
    return;
  }
  Statement(to, "INSERT OR REPLACE INTO document(key, json, crc) VALUES('ct', ?, ?)")
      .bind(0, std::string_view(document.text(0)))
      .bind(1, document.number(1))
      .step();
  Statement parts(from, "SELECT key, data FROM part WHERE key GLOB 'ct/*'");
  while (parts.step()) {
    Statement(to, "INSERT OR REPLACE INTO part(key, data) VALUES(?, ?)")
        .bind(0, std::string_view(parts.text(0)))
        .bind(1, parts.bytes(1))
        .step();
  }
}

std::shared_ptr<CtVolume> readEmbeddedCt(const Database& database, const ImageGeometry& labels, const ExecutionContext& context) {
  try {
    const Layout layout = readLayout(database, labels);
    auto ct = std::make_shared<CtVolume>();
    ct->geometry = layout.geometry;
    ct->hounsfield.resize(layout.geometry.voxelCount());
    const std::size_t parts = layout.hashes.size();
    for (std::size_t begin = 0; begin < parts; begin += kGroup) {
      context.report(static_cast<double>(begin) / static_cast<double>(parts), "voxels");
      readGroup(database, layout, begin, std::min(begin + kGroup, parts), ct->hounsfield);
    }
    return ct;
  } catch (const Json::exception&) {
    damagedCt(database, "its description cannot be read");
  } catch (const InputError&) {  // the checksum, the geometry
    damagedCt(database, "its description cannot be read");
  } catch (const std::runtime_error& error) {
    damagedCt(database, error.what());
  } catch (const std::bad_alloc&) {
    throw InputError(database.path().string() +
                     " holds an embedded CT that needs more memory than there is and is not shown; close other programs, then open "
                     "the case again.");
  }
}

}  // namespace caseTables

}  // namespace glisson
