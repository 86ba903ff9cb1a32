#pragma once
// Purpose: one JPEG 2000 frame (raw codestream or JP2) by OpenJPEG, strict: a frame that is cut off is an error.

#include <cstdint>
#include <string>
#include <vector>

namespace glisson::import {

/// The single component's values as bit patterns. Throws InputError naming `name` where the frame is damaged or has other sizes.
std::vector<std::int32_t> decodeJpeg2000(const std::string& name, const std::vector<std::uint8_t>& frame, int columns, int rows);

}  // namespace glisson::import
