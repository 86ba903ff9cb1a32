#include "reconstruction/poisson/field.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace glisson::poisson {

namespace {
constexpr std::size_t kLargePage = std::size_t{2} << 20;
constexpr std::size_t kLine = 64;
}  // namespace

void* allocateField(std::size_t bytes) {
  const std::size_t alignment = bytes >= kLargePage / 2 ? kLargePage : kLine;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  if (alignment == kLargePage) {
    (void)madvise(memory, rounded, MADV_HUGEPAGE);  // a wish: where it is refused, small pages do
  }
  return memory;
}

void freeField(void* memory) noexcept { std::free(memory); }

}  // namespace glisson::poisson
