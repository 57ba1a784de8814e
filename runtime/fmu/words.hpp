#pragma once
/// Numbers as 64-bit words, lowest byte first, one after the other: how an FMU's resource and its states are written
/// and read. `pass(io, object)` of an object passes its members to `io`, which counts, writes or reads them: what is
/// written and what is read are one list. No exceptions, and no C++ library beyond its headers.

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace bitrock::fmu {

static_assert(std::endian::native == std::endian::little, "words are in the order of memory");

/// Counts words.
struct WordCount {
  std::size_t words = 0;  ///< so far

  /// One more.
  template <class Number>
  void word(const Number&) {
    ++words;
  }
  /// A list has its own length.
  template <class Item>
  void length(const std::vector<Item>&, std::size_t) {
    ++words;
  }
};

/// Writes words to memory that has room for them.
struct WordWriter {
  char* at;  ///< of the next word

  /// One more; a whole number, a truth and an item of an enumeration as a word of 64 bits.
  template <class Number>
  void word(const Number& number) {
    if constexpr (sizeof(Number) == 8) {
      std::memcpy(at, &number, 8);
    } else {
      const auto whole = static_cast<std::int64_t>(number);
      std::memcpy(at, &whole, 8);
    }
    at += 8;
  }
  /// Its length.
  template <class Item>
  void length(const std::vector<Item>& list, std::size_t) {
    word(std::uint64_t{list.size()});
  }
};

/// Reads words. After the last it gives zeros and is no longer good; so it is after what is not a number.
struct WordReader {
  const char* at;             ///< the next word
  const char* end;            ///< behind the last
  bool keeps_lengths = true;  ///< lists must have the length they have already; otherwise they get what is read
  bool good = true;           ///< everything has been there, and fits

  /// The next.
  template <class Number>
  void word(Number& number) {
    std::int64_t whole = 0;
    if (end - at < 8) {
      good = false;
    } else {
      std::memcpy(&whole, at, 8);
      at += 8;
    }
    if constexpr (sizeof(Number) == 8) {
      std::memcpy(&number, &whole, 8);
      good = good && number == number;  // none of them is not a number
    } else if constexpr (std::is_same_v<Number, bool>) {
      good = good && (whole == 0 || whole == 1);
      number = whole == 1;
    } else {
      good = good && whole >= INT32_MIN && whole <= INT32_MAX;
      number = static_cast<Number>(good ? whole : 0);
    }
  }
  /// A list of that many. Each item has so many words, or more: a length that is too large is found before it takes
  /// memory.
  template <class Item>
  void length(std::vector<Item>& list, std::size_t words_an_item) {
    std::uint64_t count = 0;
    word(count);
    if (keeps_lengths) good = good && count == list.size();
    good = good && count <= static_cast<std::uint64_t>(end - at) / (8 * words_an_item);
    if (good && !keeps_lengths) list.resize(count);
  }
};

/// A number, a truth or an item of an enumeration.
template <class Io, class Number>
requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void pass(Io& io, Number& number) {
  io.word(number);
}

/// A list.
template <class Io, class Item>
void pass(Io& io, std::vector<Item>& list) {
  WordCount one;
  Item empty{};
  pass(one, empty);
  io.length(list, one.words);
  for (Item& item : list) pass(io, item);
}

/// Several, one after the other.
template <class Io, class... Items>
requires(sizeof...(Items) > 1) void pass_all(Io& io, Items&... items) {
  (pass(io, items), ...);
}

}  // namespace bitrock::fmu
