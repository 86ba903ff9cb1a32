#pragma once
// Purpose: a file that is written once: plain, or gzip with time stamp 0, so that the same content gives the same bytes.
// Throws Error where the disk refuses.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace glisson::sample {

inline std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

/// RFC 1952 with an empty header. level 1 (fast) .. 9 (small).
std::vector<std::byte> gzip(std::span<const std::byte> content, int level);

void writeFile(const std::filesystem::path& file, std::span<const std::byte> head, std::span<const std::byte> rest = {});

}  // namespace glisson::sample
