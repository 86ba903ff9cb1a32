// The one place where tinygltf is compiled.
#define TINYGLTF_IMPLEMENTATION
#include "planning/exchange/tiny_gltf_config.h"
