#include "reconstruction/sample/gzip_file.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "reconstruction/errors.h"

namespace glisson::sample {

std::vector<std::byte> gzip(std::span<const std::byte> content, int level) {
  z_stream stream{};
  constexpr int kGzipWindow = 15 + 16;
  if (deflateInit2(&stream, level, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw Error("The data could not be compressed because zlib did not start; free some memory and try again.");
  }
  std::vector<std::byte> packed;
  std::vector<std::byte> piece(1U << 18U);
  std::size_t taken = 0;
  int state = Z_OK;
  while (state == Z_OK) {
    if (stream.avail_in == 0) {
      const std::size_t n = std::min<std::size_t>(content.size() - taken, std::numeric_limits<uInt>::max() / 2);
      // zlib reads only, but its interface is older than const.
      stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(content.data() + taken));
      stream.avail_in = static_cast<uInt>(n);
      taken += n;
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = deflate(&stream, taken == content.size() ? Z_FINISH : Z_NO_FLUSH);
    packed.insert(packed.end(), piece.begin(), piece.end() - static_cast<std::ptrdiff_t>(stream.avail_out));
  }
  deflateEnd(&stream);
  if (state != Z_STREAM_END) {
    throw Error("The data could not be compressed because zlib reported an error; try again.");
  }
  return packed;
}

void writeFile(const std::filesystem::path& file, std::span<const std::byte> head, std::span<const std::byte> rest) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  for (const auto part : {head, rest}) {
    out.write(reinterpret_cast<const char*>(part.data()), static_cast<std::streamsize>(part.size()));
  }
  out.close();
  if (!out) {
    throw Error(file.string() + " could not be written; check that the folder can be written to and the disk is not full.");
  }
}

}  // namespace glisson::sample
