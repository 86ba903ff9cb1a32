#pragma once
// Purpose: what the text headers of NRRD and MetaImage share: bounded lines, lists of numbers, vectors. Locale-independent.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glisson::import {

/// The header's lines from the file's start: until a line for which `isLast` holds (included) or the file ends. Sets `offset` to
/// the byte behind it. Throws InputError where the header is longer than 1 MiB or a line longer than 64 KiB, or isLast never held.
struct TextHeader {
  std::vector<std::string> lines;
  std::uint64_t offset = 0;
};
TextHeader readTextHeader(const std::filesystem::path& path, bool (*isLast)(std::string_view line));

std::string trim(std::string_view text);
std::vector<std::string> words(std::string_view text);
/// All words as numbers; throws InputError naming `name` and `field` where one is not a finite number or there are not `count`.
std::vector<double> numbers(const std::string& name, const std::string& field, std::string_view text, std::size_t count);
/// An integer of at least 0 or InputError.
std::uint64_t countOf(const std::string& name, const std::string& field, std::string_view text);

}  // namespace glisson::import
