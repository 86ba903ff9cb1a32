#pragma once
// Purpose: a CT inside the case file, so that the case can be sent to somebody who has not got the images. The voxels come back as
// the same int16 values.
//   document 'ct'   geometry, slices per part, SHA-256 of each part's voxels; nothing about the patient
//   part 'ct/N'     slices, packing.h
// Private to storage/ but for embeddedCtBytes(). A program that does not know it leaves it alone.

#include <cstdint>
#include <memory>

#include "reconstruction/execution_context.h"
#include "reconstruction/image/ct_volume.h"

namespace glisson {

class Database;

/// About how many bytes a CT adds to a case file, judged by a few of its slices.
std::uint64_t embeddedCtBytes(const CtVolume& ct);

namespace caseTables {

bool hasEmbeddedCt(const Database& database);
/// Opens no transaction. Throws InputError where the CT is larger than 4 GiB, Cancelled (polled between parts).
void writeEmbeddedCt(const Database& database, const CtVolume& ct, const ExecutionContext& context);
/// As it is, damage included.
void copyEmbeddedCt(const Database& from, const Database& to);
/// With geometry and voxels; identity and source are left to the caller. Memory is taken only for what the parts can hold. Throws
/// InputError where it is damaged or not on `labels`, Cancelled (polled between parts).
std::shared_ptr<CtVolume> readEmbeddedCt(const Database& database, const ImageGeometry& labels, const ExecutionContext& context);

}  // namespace caseTables

}  // namespace glisson
