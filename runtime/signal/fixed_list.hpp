#pragma once
/// A list whose room lies inside it. The signal uses it in place of std::vector because its owner must be one block of
/// bytes: no pointer, so that copying the bytes copies the list, and no heap. It does not check its bound; whoever adds
/// says why there is room.

#include <array>
#include <cstddef>

namespace bitrock::runtime {

template <class Item, std::size_t most>
struct FixedList {
  std::array<Item, most> items;
  std::size_t count = 0;

  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  Item* begin() { return items.data(); }
  Item* end() { return items.data() + count; }
  const Item* begin() const { return items.data(); }
  const Item* end() const { return items.data() + count; }
  Item& operator[](std::size_t i) { return items.data()[i]; }
  const Item& operator[](std::size_t i) const { return items.data()[i]; }
  void clear() { count = 0; }
  void push_back(const Item& item) { items.data()[count++] = item; }
};

}  // namespace bitrock::runtime
