#include "reconstruction/io/import/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "reconstruction/errors.h"

namespace glisson::import {

struct ByteSource::Inflater {
  z_stream stream{};
  std::array<std::uint8_t, 1 << 16> input{};
  bool gzip = true;
  bool ended = false;
};

ByteSource::ByteSource(const std::filesystem::path& path, std::uint64_t offset, Coding coding) : path_(path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  file_ = error ? nullptr : std::fopen(path.c_str(), "rbe");
  if (file_ == nullptr) {
    throw InputError(path.string() + " cannot be opened; check that it is a file and that you may read it.");
  }
  left_ = size - std::min(size, offset);
  if (fseeko(file_, static_cast<off_t>(std::min(size, offset)), SEEK_SET) != 0) {
    left_ = 0;
  }
  if (coding != Coding::Raw) {
    inflater_ = std::make_unique<Inflater>();
    inflater_->gzip = coding == Coding::Gzip;
    if (inflateInit2(&inflater_->stream, inflater_->gzip ? 15 + 16 : 15 + 32) != Z_OK) {
      throw std::bad_alloc();
    }
  }
}

ByteSource::~ByteSource() {
  if (inflater_) {
    inflateEnd(&inflater_->stream);
  }
  if (file_ != nullptr) {
    static_cast<void>(std::fclose(file_));
  }
}

std::size_t ByteSource::readFile(void* data, std::size_t size) {
  const std::size_t n = std::fread(data, 1, std::min<std::uint64_t>(size, left_), file_);
  left_ -= n;
  if (n < size && left_ > 0) {
    throw InputError(path_.string() + " cannot be read to its end; check the disk or the network.");
  }
  return n;
}

std::size_t ByteSource::read(void* data, std::size_t size) {
  return inflater_ ? readInflated(static_cast<std::uint8_t*>(data), size) : readFile(data, size);
}

std::size_t ByteSource::readInflated(std::uint8_t* data, std::size_t size) {
  z_stream& stream = inflater_->stream;
  std::size_t done = 0;
  while (done < size && !inflater_->ended) {
    if (stream.avail_in == 0) {
      stream.next_in = inflater_->input.data();
      stream.avail_in = static_cast<uInt>(readFile(inflater_->input.data(), inflater_->input.size()));
      if (stream.avail_in == 0) {
        throw InputError(path_.string() + " is cut off: its compressed data end early; copy or export it again.");
      }
    }
    const auto piece = static_cast<uInt>(std::min<std::size_t>(size - done, 1U << 30));
    stream.next_out = data + done;
    stream.avail_out = piece;
    const int result = inflate(&stream, Z_NO_FLUSH);
    done += piece - stream.avail_out;
    if (result == Z_STREAM_END) {
      beginMember();
    } else if (result != Z_OK) {
      throw InputError(path_.string() + " is damaged: its compressed data or their checksum are wrong; copy or export it again.");
    }
  }
  return done;
}

/// gzip files may be several members in a row (pigz, bgzip); anything else behind the end is not ours.
void ByteSource::beginMember() {
  z_stream& stream = inflater_->stream;
  const bool more = stream.avail_in > 0 || left_ > 0;
  if (!more) {
    inflater_->ended = true;
    return;
  }
  if (!inflater_->gzip || inflateReset(&stream) != Z_OK) {
    throw InputError(path_.string() + " holds more behind the end of its compressed data; copy or export it again.");
  }
}

std::uint64_t ByteSource::mostBytesLeft() const {
  if (!inflater_) {
    return left_;
  }
  constexpr std::uint64_t kDeflateLimit = 1032;
  return (left_ + inflater_->stream.avail_in + 64) * kDeflateLimit + (1U << 16);
}

}  // namespace glisson::import
