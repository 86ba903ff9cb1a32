#pragma once
// Purpose: the types a voxel may have in a file.

#include <cstddef>
#include <cstdint>

namespace glisson::import {

enum class Scalar : std::uint8_t { U8, I8, U16, I16, U32, I32, U64, I64, F32, F64 };
std::size_t bytesOf(Scalar scalar);

}  // namespace glisson::import
