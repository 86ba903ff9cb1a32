#pragma once
// Purpose: files that are either wholly written or not there: bytes go to a temporary file beside the target, are fsynced, and the
// name is moved over. A full disk or a missing right leaves the file that was there before.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace glisson {

/// No file that is read here is larger: sizes are checked before memory is asked for.
inline constexpr std::uintmax_t kLargestMeshFile = std::uintmax_t{2} << 30U;

/// Writes `bytes` to `path`, replacing what is there only by a complete file. Throws InputError (names path and reason); then
/// nothing is left behind and an older file is intact.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The whole file. Throws InputError where it cannot be read or is larger than kLargestMeshFile.
std::string readWholeFile(const std::filesystem::path& path);

/// fsync of a folder, so that names just made or moved survive a power cut. Throws InputError.
void syncFolder(const std::filesystem::path& folder);

}  // namespace glisson
