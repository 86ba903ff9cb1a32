#pragma once
// Purpose: lists made by several threads in an order that does not depend on them.

#include <algorithm>
#include <iterator>
#include <vector>

#include "reconstruction/parallel.h"

namespace glisson {

/// Appends to `items` what append(begin, end, some) appends to `some` for pieces of [0, count) of a fixed size, in their order.
template <typename Item, typename Append>
void parallelAppend(std::size_t count, std::vector<Item>& items, const Append& append) {
  constexpr std::size_t kPiece = 1024;
  std::vector<std::vector<Item>> pieces((count + kPiece - 1) / kPiece);
  parallelFor(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      append(n * kPiece, std::min((n + 1) * kPiece, count), pieces[n]);
    }
  });
  std::size_t size = items.size();
  for (const std::vector<Item>& piece : pieces) {
    size += piece.size();
  }
  items.reserve(size);
  for (std::vector<Item>& piece : pieces) {
    items.insert(items.end(), std::make_move_iterator(piece.begin()), std::make_move_iterator(piece.end()));
  }
}

}  // namespace glisson
