#pragma once
// Purpose: what passes between the program and its child glisson-import, as two files in a private temporary folder: a request and
// an answer. The answer comes from a process that has parsed hostile bytes, so reading it checks every size before it is trusted.
// Layout: little-endian as in memory (both ends are the same build), each text and array with its 64-bit length in front.

#include <filesystem>
#include <string>
#include <variant>

#include "reconstruction/io/read.h"

namespace glisson {

enum class ImportTask : std::uint8_t { Ct, Segmentation, Guess };

struct ImportRequest {
  ImportTask task = ImportTask::Ct;
  std::filesystem::path path;
  ReadOptions options;  ///< timeLimitSeconds is the parent's affair and does not pass
};

/// One sentence for the user instead of a result.
struct ImportFailure {
  std::string message;
};

using ImportAnswer = std::variant<ImportFailure, CtVolume, Segmentation, InputKind>;

/// All four throw std::runtime_error where a file cannot be written, or holds anything but one whole valid message.
void writeRequest(const std::filesystem::path& file, const ImportRequest& request);
ImportRequest readRequest(const std::filesystem::path& file);
void writeAnswer(const std::filesystem::path& file, const ImportAnswer& answer);
ImportAnswer readAnswer(const std::filesystem::path& file);

}  // namespace glisson
