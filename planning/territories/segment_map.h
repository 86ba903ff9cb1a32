#pragma once
// Purpose: a map of liver segments 1 to 8 from a file or a folder of masks, instead of branches of the portal vein. A case keeps
// where the map lies and what it said, as SHA-256 of its segments on the case's grid; the map is read again when the territories
// are estimated.

#include <filesystem>

#include "planning/case/case.h"
#include "planning/territories/territories.h"
#include "reconstruction/io/read.h"

namespace glisson {

/// The territories of a map that is read for the first time: on the grid of the case and of its patient, unless `options` accept
/// another. Notes of the reader are theirs. Throws InputError, also where it has no label 1 to 8 inside the liver, Cancelled.
Territories segmentTerritories(const Case& source, const std::filesystem::path& path, const ReadOptions& options = {},
                               const ExecutionContext& context = {});

/// As a case keeps a map that has been read.
SegmentMapFile segmentMapFile(const std::filesystem::path& path, const Territories& read);

/// What a choice says, whatever its source; no parts where nothing could be proposed. A map that the case keeps was accepted then
/// and is accepted again; throws InputError where it cannot be read or does not say what it said. Throws what territoriesOf() of
/// branches throws, Cancelled.
Territories territoriesOf(const Case& source, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context = {});

}  // namespace glisson
