#pragma once
// Purpose: long arrays of numbers, such as the values of a grid's nodes. New elements are left as they are, so that the threads
// that fill an array touch its memory first; long ones ask the system for large pages, which spares thousands of page faults.

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace glisson::poisson {

/// Throws std::bad_alloc.
void* allocateField(std::size_t bytes);
void freeField(void* memory) noexcept;

template <typename T>
struct FieldAllocator {
  using value_type = T;
  FieldAllocator() = default;
  template <typename U>
  explicit FieldAllocator(const FieldAllocator<U>& /*other*/) noexcept {}
  [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(allocateField(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t /*count*/) noexcept { freeField(memory); }
  template <typename U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename Value>
  void construct(U* at, Value&& value) noexcept {
    ::new (static_cast<void*>(at)) U(std::forward<Value>(value));
  }
  bool operator==(const FieldAllocator&) const = default;
};

/// LargeArray<T>(n) of numbers is not initialised.
template <typename T>
using LargeArray = std::vector<T, FieldAllocator<T>>;

/// Field(n) is not initialised; Field(n, 0.0F) is zero.
using Field = LargeArray<float>;

}  // namespace glisson::poisson
