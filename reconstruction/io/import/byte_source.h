#pragma once
// Purpose: bytes of a file from an offset on, plain or inflated, with nothing believed: gzip's checksum and length and zlib's
// checksum are verified at the end of the stream, and the caller is told where the stream ends.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace glisson::import {

/// Zlib: one zlib or gzip stream, as MetaIO takes either; Gzip: one or more gzip members.
enum class Coding : std::uint8_t { Raw, Gzip, Zlib };

class ByteSource {
 public:
  /// Throws InputError where the file cannot be opened.
  ByteSource(const std::filesystem::path& path, std::uint64_t offset, Coding coding);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Reads up to `size` bytes; fewer only at the end. Throws InputError where the compressed data are damaged or cut off.
  std::size_t read(void* data, std::size_t size);
  /// The most bytes that may still come: what is left of a raw file, deflate's limit of 1032:1 for a compressed one.
  [[nodiscard]] std::uint64_t mostBytesLeft() const;

 private:
  struct Inflater;
  std::size_t readFile(void* data, std::size_t size);
  std::size_t readInflated(std::uint8_t* data, std::size_t size);
  void beginMember();

  std::filesystem::path path_;
  std::FILE* file_ = nullptr;
  std::uint64_t left_ = 0;
  std::unique_ptr<Inflater> inflater_;
};

}  // namespace glisson::import
