#pragma once
// Purpose: a map of liver segments 1 to 8 from a file, instead of branches of the portal vein. A case keeps where the map lies and
// its SHA-256, and it is read again when the territories are estimated.

#include <filesystem>

#include "planning/case/case.h"
#include "planning/territories/territories.h"
#include "reconstruction/io/read.h"

namespace glisson {

/// The map at `path` (a file, or a folder of masks) as it is kept. Throws InputError where there is nothing to read.
SegmentMapFile segmentMapFile(const std::filesystem::path& path);

/// The territories of a map that is read for the first time: on the grid of the case and of its patient, unless `options` accept
/// another. Throws InputError, also where it has no label 1 to 8 inside the liver, Cancelled.
Territories segmentTerritories(const Case& source, const SegmentMapFile& map, const ReadOptions& options = {},
                               const ExecutionContext& context = {});

/// What a choice says, whatever its source. A map that the case has kept was accepted then and is read as it is; throws InputError
/// where it is missing or its files have changed. Throws what territoriesOf() of branches throws, Cancelled.
Territories territoriesOf(const Case& source, const VesselGraph& portal, const TerritoryChoice& choice,
                          const ExecutionContext& context = {});

}  // namespace glisson
