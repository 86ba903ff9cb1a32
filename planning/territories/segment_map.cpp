#include "planning/territories/segment_map.h"

#include "planning/storage/ct_files.h"
#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace fs = std::filesystem;

SegmentMapFile segmentMapFile(const fs::path& path) {
  const std::vector<CtFileHash> files = hashCtFiles(path);
  if (files.empty()) {
    throw InputError("The map of segments is not at " + path.string() + "; choose it again.");
  }
  std::string listed;
  for (const CtFileHash& file : files) {
    listed += file.name + '\n' + file.sha256 + '\n';
  }
  const bool single = fs::is_regular_file(path);
  return {fs::absolute(path).lexically_normal().string(),
          single ? files.front().sha256 : sha256Hex(std::as_bytes(std::span(listed)))};
}

Territories segmentTerritories(const Case& source, const SegmentMapFile& map, const ReadOptions& options,
                               const ExecutionContext& context) {
  CtVolume grid;
  grid.geometry = source.segmentation->geometry;
  grid.identity = source.identity;
  if (source.ctSource.empty()) {
    grid.identity.patientId = source.segmentation->patientId;
    grid.identity.frameOfReferenceUid = source.segmentation->frameOfReferenceUid;
  }
  grid.source = source.ctSource.empty() ? source.segmentation->source : source.ctSource;
  return segmentTerritories(*source.liver, matchToCt(readSegmentation(map.path, options, context), grid, options));
}

Territories territoriesOf(const Case& source, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context) {
  if (!choice.segments) {
    return territoriesOf(*source.liver, portal, choice, context);
  }
  if (segmentMapFile(choice.segments->path) != *choice.segments) {
    throw InputError("The map of segments at " + choice.segments->path +
                     " is not the one that was chosen (its files have changed); choose it again.");
  }
  ReadOptions options;
  options.consents = {Consent::ResampleLabels, Consent::OtherPatient, Consent::Tilt, Consent::UnevenSlices};
  return segmentTerritories(source, *choice.segments, options, context);
}

}  // namespace glisson
