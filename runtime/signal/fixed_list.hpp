#pragma once
/// A list whose room lies inside it. The signal uses it in place of std::vector because its owner must be one block of
/// bytes: no pointer, so that copying the bytes copies the list, and no heap. It does not check its bound; whoever adds
/// says why there is room.

#include <array>
#include <cstddef>

namespace bitrock::runtime {

template <class Item, std::size_t most>
struct FixedList {
  std::array<Item, most> items;  ///< the first `count` of them count
  std::size_t count = 0;         ///< of those that are there

  /// Number of items.
  std::size_t size() const { return count; }
  /// Whether there is none.
  bool empty() const { return count == 0; }
  /// The first.
  Item* begin() { return items.data(); }
  /// Behind the last.
  Item* end() { return items.data() + count; }
  /// The first.
  const Item* begin() const { return items.data(); }
  /// Behind the last.
  const Item* end() const { return items.data() + count; }
  /// Item i, which must be there.
  Item& operator[](std::size_t i) { return items.data()[i]; }
  /// Item i, which must be there.
  const Item& operator[](std::size_t i) const { return items.data()[i]; }
  /// Takes all out.
  void clear() { count = 0; }
  /// There must be room.
  void push_back(const Item& item) { items.data()[count++] = item; }
};

}  // namespace bitrock::runtime
