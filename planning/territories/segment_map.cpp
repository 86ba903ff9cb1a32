#include "planning/territories/segment_map.h"

#include <exception>

#include "planning/storage/sha256.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace fs = std::filesystem;

namespace {

std::string fingerprintOf(const Territories& territories) {
  Sha256 hash;
  for (const Territory& part : territories.parts) {
    hash.update(std::as_bytes(std::span(part.name)));
    hash.update(std::as_bytes(std::span(part.rows.runs)));
  }
  return hash.hex();
}

/// The map as it was when it was chosen.
Territories readKeptMap(const Case& source, const SegmentMapFile& map, const ExecutionContext& context) {
  ReadOptions options;
  options.consents = {Consent::ResampleLabels, Consent::OtherPatient, Consent::Tilt, Consent::UnevenSlices};
  std::exception_ptr refusal;
  bool anyRead = false;
  for (const NiftiFrame frame : {NiftiFrame::Agreeing, NiftiFrame::SForm, NiftiFrame::QForm}) {
    options.niftiFrame = frame;
    try {
      Territories read = segmentTerritories(source, map.path, options, context);
      if (fingerprintOf(read) == map.sha256) {
        return read;
      }
      anyRead = true;
      if (frame == NiftiFrame::Agreeing) {
        break;
      }
    } catch (const InputError&) {  // perhaps its two frames differ, and one of them was chosen
      refusal = refusal ? refusal : std::current_exception();
    }
  }
  if (!anyRead) {
    std::rethrow_exception(refusal);
  }
  throw InputError("The map of segments at " + map.path +
                   " does not say any more what it said when it was chosen; choose it again.");
}

}  // namespace

Territories segmentTerritories(const Case& source, const fs::path& path, const ReadOptions& options,
                               const ExecutionContext& context) {
  CtVolume grid;
  grid.geometry = source.segmentation->geometry;
  grid.identity = source.identity;
  if (source.ctSource.empty()) {
    grid.identity.patientId = source.segmentation->patientId;
    grid.identity.frameOfReferenceUid = source.segmentation->frameOfReferenceUid;
  }
  grid.source = source.ctSource.empty() ? source.segmentation->source : source.ctSource;
  return segmentTerritories(*source.liver, matchToCt(readSegmentation(path, options, context), grid, options));
}

SegmentMapFile segmentMapFile(const fs::path& path, const Territories& read) {
  return {fs::absolute(path).lexically_normal().string(), fingerprintOf(read)};
}

Territories territoriesOf(const Case& source, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context) {
  if (choice.segments) {
    return readKeptMap(source, *choice.segments, context);
  }
  if (choice.picks.empty()) {
    Territories none;
    none.geometry = source.liver->geometry;
    none.source = choice.source;
    none.notes = choice.notes;
    return none;
  }
  return territoriesOf(*source.liver, portal, choice, context);
}

}  // namespace glisson
