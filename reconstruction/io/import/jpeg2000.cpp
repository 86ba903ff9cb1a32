#include "reconstruction/io/import/jpeg2000.h"

#include <openjpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "reconstruction/errors.h"

namespace glisson::import {

namespace {
struct Memory {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::size_t at = 0;
};

OPJ_SIZE_T readMemory(void* buffer, OPJ_SIZE_T wanted, void* user) {
  auto* memory = static_cast<Memory*>(user);
  const std::size_t n = std::min<std::size_t>(wanted, memory->size - memory->at);
  if (n == 0) {
    return static_cast<OPJ_SIZE_T>(-1);
  }
  std::memcpy(buffer, memory->data + memory->at, n);
  memory->at += n;
  return n;
}

OPJ_OFF_T skipMemory(OPJ_OFF_T wanted, void* user) {
  auto* memory = static_cast<Memory*>(user);
  if (wanted < 0 || static_cast<std::size_t>(wanted) > memory->size - memory->at) {
    return -1;
  }
  memory->at += static_cast<std::size_t>(wanted);
  return wanted;
}

OPJ_BOOL seekMemory(OPJ_OFF_T wanted, void* user) {
  auto* memory = static_cast<Memory*>(user);
  if (wanted < 0 || static_cast<std::size_t>(wanted) > memory->size) {
    return OPJ_FALSE;
  }
  memory->at = static_cast<std::size_t>(wanted);
  return OPJ_TRUE;
}

void dropMessage(const char* /*message*/, void* /*user*/) {}

using Codec = std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)>;
using Stream = std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)>;
using Image = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;
}  // namespace

std::vector<std::int32_t> decodeJpeg2000(const std::string& name, const std::vector<std::uint8_t>& frame, int columns, int rows) {
  const auto refuse = [&]() -> void {
    throw InputError(name + " has a JPEG 2000 frame that is damaged or cut off; copy or export the series again.");
  };
  const bool codestream = frame.size() > 4 && frame[0] == 0xFF && frame[1] == 0x4F;
  Memory memory{frame.data(), frame.size(), 0};
  const Codec codec(opj_create_decompress(codestream ? OPJ_CODEC_J2K : OPJ_CODEC_JP2), &opj_destroy_codec);
  const Stream stream(opj_stream_create(1 << 16, OPJ_TRUE), &opj_stream_destroy);
  if (!codec || !stream) {
    throw std::bad_alloc();
  }
  opj_set_error_handler(codec.get(), dropMessage, nullptr);
  opj_set_warning_handler(codec.get(), dropMessage, nullptr);
  opj_set_info_handler(codec.get(), dropMessage, nullptr);
  opj_stream_set_user_data(stream.get(), &memory, nullptr);
  opj_stream_set_user_data_length(stream.get(), frame.size());
  opj_stream_set_read_function(stream.get(), readMemory);
  opj_stream_set_skip_function(stream.get(), skipMemory);
  opj_stream_set_seek_function(stream.get(), seekMemory);
  opj_dparameters_t parameters;
  opj_set_default_decoder_parameters(&parameters);
  if (opj_setup_decoder(codec.get(), &parameters) == OPJ_FALSE || opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE) == OPJ_FALSE) {
    refuse();
  }
  opj_image_t* raw = nullptr;
  const bool headed = opj_read_header(stream.get(), codec.get(), &raw) == OPJ_TRUE;
  const Image image(raw, &opj_image_destroy);
  if (!headed || !image || image->numcomps != 1 || image->x1 - image->x0 != static_cast<OPJ_UINT32>(columns) ||
      image->y1 - image->y0 != static_cast<OPJ_UINT32>(rows)) {
    refuse();
  }
  if (opj_decode(codec.get(), stream.get(), image.get()) == OPJ_FALSE ||
      opj_end_decompress(codec.get(), stream.get()) == OPJ_FALSE) {
    refuse();
  }
  const opj_image_comp_t& component = image->comps[0];
  if (component.data == nullptr || component.w != static_cast<OPJ_UINT32>(columns) ||
      component.h != static_cast<OPJ_UINT32>(rows)) {
    refuse();
  }
  return {component.data, component.data + static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)};
}

}  // namespace glisson::import
