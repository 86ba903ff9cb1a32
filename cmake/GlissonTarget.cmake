# What every target of the project has in common: C++20, warnings, repeatable floating point, precompiled standard headers.
include_guard()
find_program(GLISSON_CCACHE ccache)
if(GLISSON_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # What one clone compiled serves another in another folder: paths are hashed and compiled relative to the source folder.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
                                  CCACHE_NOHASHDIR=1 ${GLISSON_CCACHE})
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

if(GLISSON_SANITIZE)
  # With sanitizers GCC no longer sees what an optional's flag guards, and warns of values that are never read.
  set(GLISSON_SANITIZER_OPTIONS -O1 -fsanitize=${GLISSON_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -Wno-maybe-uninitialized)
  if(NOT GLISSON_SANITIZE_ALL)
    list(APPEND GLISSON_SANITIZER_OPTIONS -fno-sanitize=null,alignment,object-size,vptr)
  endif()
  # A room calls its own copy of a template or inline function, which has the sanitizer in it; a test's copy may not.
  set(BUILD_SHARED_LIBS ON)
  add_link_options(-fsanitize=${GLISSON_SANITIZE} LINKER:-Bsymbolic-functions)
endif()
if(GLISSON_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()

# glisson_target(NAME [REUSE_FROM TARGET | FEW_FILES]): call once per target. Includes are written from the project's root:
# #include "reconstruction/mesh/surface_mesh.h". REUSE_FROM: the precompiled headers of another target of the same kind. FEW_FILES: none,
# since precompiling takes longer than a few files without.
function(glisson_target name)
  cmake_parse_arguments(T "FEW_FILES" "REUSE_FROM" "" ${ARGN})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE JSON_USE_IMPLICIT_CONVERSIONS=0)  # else JSON is an argument for any function of its name
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
                                         -Woverloaded-virtual -ffp-contract=off ${GLISSON_SANITIZER_OPTIONS})
  if(CMAKE_UNITY_BUILD)
    target_compile_options(${name} PRIVATE -Wno-subobject-linkage)  # a class in a .cpp may hold what only its file knows
  endif()
  if(GLISSON_WERROR)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
  if(T_REUSE_FROM)
    target_precompile_headers(${name} REUSE_FROM ${T_REUSE_FROM})
  elseif(NOT T_FEW_FILES)
    target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional>
                              <set> <span> <string> <string_view> <unordered_map> <vector> <Eigen/Core> <Eigen/LU>)
  endif()
endfunction()
