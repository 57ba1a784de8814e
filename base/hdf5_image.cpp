#include "base/hdf5_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

// Each number of the format, and each of ours, is little-endian.
constexpr std::uint64_t nowhere = ~std::uint64_t{0};  ///< the address of what is not stored
constexpr int deepest_group = 8;                      ///< our paths have three parts
constexpr std::size_t longest_name = 255;             ///< of a part of a path; ours have at most 30 letters
/// Deflate makes at most 1032 bytes of one [Deutsch1996]: 258 bytes by two bits.
constexpr std::uint64_t largest_ratio = 1032;

/// Kinds of header messages [HDF5Format, sec. IV.A.2].
enum Message : unsigned {
  nil = 0x00,
  dataspace = 0x01,
  datatype = 0x03,
  old_fill_value = 0x04,
  fill_value = 0x05,
  layout = 0x08,
  filter_pipeline = 0x0b,
  attribute = 0x0c,
  old_modification_time = 0x0e,
  continuation = 0x10,
  symbol_table = 0x11,
  modification_time = 0x12
};

struct HeaderMessage {
  unsigned kind = 0;
  std::string_view bytes;
};

/// The kinds of values that we write, as the format spells them; a text says its length itself.
constexpr std::array<std::pair<std::string_view, Hdf5Kind>, 5> number_types{
    {{std::string_view("\x10\0\0\0\x01\0\0\0\0\0\x08\0", 12), Hdf5Kind::byte},
     {std::string_view("\x10\x08\0\0\x04\0\0\0\0\0\x20\0", 12), Hdf5Kind::int32},
     {std::string_view("\x10\x08\0\0\x08\0\0\0\0\0\x40\0", 12), Hdf5Kind::int64},
     {std::string_view("\x11\x20\x1f\0\x04\0\0\0\0\0\x20\0\x17\x08\0\x17\x7f\0\0\0", 20), Hdf5Kind::real32},
     {std::string_view("\x11\x20\x3f\0\x08\0\0\0\0\0\x40\0\x34\x0b\0\x34\xff\x03\0\0", 20), Hdf5Kind::real64}}};

/// What lies in a piece of the file, read from front to back.
class Reading {
 public:
  Reading(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}
  std::size_t left() const { return bytes_.size(); }

  std::string_view take(std::uint64_t count) {
    if (count > bytes_.size()) refuse("is cut short");
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    const std::string_view digits = take(bytes);
    for (std::size_t i = bytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(digits[i]);
    return value;
  }
  void skip(std::uint64_t count) { take(count); }
  void expect(std::string_view mark) {
    if (take(mark.size()) != mark) refuse("is not what bitrock writes there");
  }
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(where_ + " " + why); }

 private:
  std::string_view bytes_;
  const std::string& where_;
};

std::uint64_t padded(std::uint64_t bytes) {
  return (bytes + 7) / 8 * 8;
}

/// Walks through a file once. What is read is paid for: our structures never overlap, so all of them together are no
/// longer than the file, and a file that leads in circles is soon out of means.
class Walk {
 public:
  Walk(std::string_view file, const std::string& name) : file_(file), name_(name), where_(name), means_(file.size()) {}

  Hdf5Image image() {
    where_ = name_ + ": the head of the file";
    Reading head(at(0, 96), where_);
    head.expect("\x89HDF\r\n\x1a\n");
    head.expect(std::string_view("\0\0\0\0\0\x08\x08\0", 8));  // versions; addresses and lengths of 8 bytes
    head.skip(2 + 2 + 4);                                      // sizes of nodes, flags
    if (head.number(8) != 0) head.refuse("begins with bytes of another format");
    head.skip(8);  // free space
    if (head.number(8) > file_.size()) head.refuse("tells of a longer file (it is cut short)");
    head.skip(8 + 8);  // driver, name of the root
    const std::uint64_t root = head.number(8);
    where_ = name_ + ": the root group";
    group("", messages(root), 0);
    return std::move(image_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(where_ + " " + why); }

  std::string_view at(std::uint64_t address, std::uint64_t bytes) {
    if (address > file_.size() || bytes > file_.size() - address) refuse("lies outside the file");
    if (bytes > means_) refuse("overlaps something else");
    means_ -= bytes;
    return file_.substr(static_cast<std::size_t>(address), static_cast<std::size_t>(bytes));
  }

  /// The messages of an object header, version 1, wherever they lie.
  std::vector<HeaderMessage> messages(std::uint64_t address) {
    Reading head(at(address, 16), where_);
    head.expect(std::string_view("\x01\0", 2));
    const std::uint64_t most = head.number(2);
    head.skip(4);  // how many names it has
    std::vector<std::string_view> blocks{at(address + 16, head.number(4))};
    std::vector<HeaderMessage> found;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
      for (Reading rest(blocks[block], where_); found.size() < most && rest.left() >= 8;) {
        const auto kind = static_cast<unsigned>(rest.number(2));
        const std::uint64_t size = rest.number(2), flags = rest.number(1);
        rest.skip(3);
        found.push_back({kind, rest.take(size)});
        constexpr std::uint64_t shared = 2;
        if ((flags & shared) != 0 && kind != nil) refuse("refers to something shared, which bitrock does not write");
        if (kind != continuation) continue;
        Reading next(found.back().bytes, where_);
        const std::uint64_t begin = next.number(8);
        blocks.push_back(at(begin, next.number(8)));
      }
    }
    return found;
  }

  /// The names of a group: B-tree, version 1, over tables of symbols.
  void group(const std::string& path, const std::vector<HeaderMessage>& all, int depth) {
    if (depth > deepest_group) refuse(fmt::format("lies deeper than {} groups", deepest_group));
    std::uint64_t tree = nowhere, heap = nowhere;
    for (const HeaderMessage& message : all) {
      if (message.kind == symbol_table && tree == nowhere) {
        Reading table(message.bytes, where_);
        tree = table.number(8);
        heap = table.number(8);
      } else if (message.kind == attribute) {
        if (path.empty()) root_attribute(message.bytes);
      } else if (message.kind != nil && message.kind != continuation) {
        refuse(fmt::format("holds a message of kind {} (a link of a kind that bitrock does not write?)", message.kind));
      }
    }
    if (tree == nowhere) refuse("has no names");
    std::vector<std::pair<std::string, std::uint64_t>> members;
    names(tree, heap_of(heap), members, -1);
    for (const auto& [member, where] : members) object(path + "/" + member, where, depth + 1);
  }

  std::string_view heap_of(std::uint64_t address) {
    Reading head(at(address, 32), where_);
    head.expect(std::string_view("HEAP\0\0\0\0", 8));
    const std::uint64_t size = head.number(8);
    head.skip(8);
    return at(head.number(8), size);
  }

  /// `level` is that of the node above minus 1; -1: any.
  void names(std::uint64_t address, std::string_view heap, std::vector<std::pair<std::string, std::uint64_t>>& members,
             int level) {
    const Node node = node_head(address, '\0', level);
    Reading entries(at(address + 24, node.used * 16), where_);
    for (std::uint64_t i = 0; i < node.used; ++i) {
      entries.skip(8);
      const std::uint64_t child = entries.number(8);
      if (node.level > 0) {
        names(child, heap, members, node.level - 1);
      } else {
        symbols(child, heap, members);
      }
    }
  }

  void symbols(std::uint64_t address, std::string_view heap,
               std::vector<std::pair<std::string, std::uint64_t>>& members) {
    Reading head(at(address, 8), where_);
    head.expect(std::string_view("SNOD\x01\0", 6));
    const std::uint64_t count = head.number(2);
    Reading entries(at(address + 8, count * 40), where_);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t offset = entries.number(8), header = entries.number(8), link = entries.number(4);
      entries.skip(4 + 16);
      if (offset >= heap.size()) refuse("has a name outside its list of names");
      const std::string_view rest = heap.substr(static_cast<std::size_t>(offset), longest_name + 1);
      const std::string name = our_name(rest.substr(0, rest.find('\0')));
      constexpr std::uint64_t object_or_group = 1;
      if (link > object_or_group) refuse(fmt::format("holds {} as a link (links are not followed)", name));
      members.emplace_back(name, header);
    }
  }

  /// A name can be printed, and is no path.
  std::string our_name(std::string_view name) {
    const auto is_ours = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    if (name.empty() || name.size() > longest_name || !std::all_of(name.begin(), name.end(), is_ours)) {
      refuse("holds a name that bitrock does not write (letters, digits and underlines)");
    }
    return std::string(name);
  }

  struct Node {
    int level = 0;
    std::uint64_t used = 0;
  };
  Node node_head(std::uint64_t address, char kind, int level) {
    Reading head(at(address, 24), where_);
    head.expect("TREE");
    head.expect(std::string_view(&kind, 1));
    const Node node{static_cast<int>(head.number(1)), head.number(2)};
    if (level >= 0 && node.level != level) refuse("is not a tree");
    return node;
  }

  void object(const std::string& path, std::uint64_t address, int depth) {
    where_ = fmt::format("{}: {}", name_, path);
    const std::vector<HeaderMessage> all = messages(address);
    const bool is_group = std::any_of(all.begin(), all.end(), [](const auto& one) { return one.kind == symbol_table; });
    if (is_group) {
      group(path, all, depth);
    } else if (!image_.arrays.emplace(path, array(all)).second) {
      refuse("is there twice");
    }
  }

  Hdf5Array array(const std::vector<HeaderMessage>& all) {
    std::array<std::string_view, 12> only{};
    for (const HeaderMessage& message : all) {
      switch (message.kind) {
        case dataspace:
        case datatype:
        case layout:
        case filter_pipeline:
          if (only[message.kind].data() != nullptr) refuse("is told twice what it is");
          only[message.kind] = message.bytes;
          break;
        case nil:
        case old_fill_value:
        case fill_value:
        case attribute:
        case continuation:
        case old_modification_time:
        case modification_time:
          break;
        default:
          refuse(fmt::format("holds a message of kind {}, which bitrock does not write (data in another file?)",
                             message.kind));
      }
    }
    Hdf5Array made;
    const std::vector<std::uint64_t> extent = dimensions(only[dataspace]);
    if (extent.size() != 1) refuse("must have one dimension");
    const Type type = type_of(only[datatype]);
    if (type.kind == Hdf5Kind::text) refuse("holds texts (must be numbers)");
    made.kind = type.kind;
    if (only[filter_pipeline].data() != nullptr) made.filters = filters(only[filter_pipeline]);
    where_it_lies(made, only[layout], extent[0]);
    return made;
  }

  std::vector<std::uint64_t> dimensions(std::string_view bytes) {
    Reading space(bytes, where_);
    const std::uint64_t version = space.number(1), rank = space.number(1);
    if (version != 1 && version != 2) space.refuse("has an extent of an unknown kind");
    space.skip(version == 1 ? 1 + 5 : 1 + 1);
    std::vector<std::uint64_t> extent;
    for (std::uint64_t i = 0; i < rank; ++i) extent.push_back(space.number(8));
    return extent;
  }

  struct Type {
    Hdf5Kind kind{};
    std::uint64_t bytes = 0;
  };
  Type type_of(std::string_view bytes) {
    for (const auto& [spelt, kind] : number_types) {
      if (bytes.starts_with(spelt)) return {kind, value_bytes(kind)};
    }
    Reading type(bytes, where_);
    constexpr std::uint64_t text_class = 3, variable_class = 9, text_of_variable_length = 1;
    const std::uint64_t kind = type.number(1) & 0x0f, detail = type.number(1) & 0x0f;
    type.skip(2);
    if (kind == text_class) return {Hdf5Kind::text, type.number(4)};
    if (kind == variable_class && detail == text_of_variable_length) {
      refuse(
          "is a text of variable length, as earlier builds of bitrock wrote (such texts are not read: make the file "
          "again with this one)");
    }
    refuse(fmt::format("holds values of a kind that bitrock does not write (class {})", kind));
  }

  void root_attribute(std::string_view bytes) {
    const std::string group = std::exchange(where_, name_ + ": an attribute");
    Reading message(bytes, where_);
    message.expect(std::string_view("\x01\0", 2));
    const std::uint64_t name_size = message.number(2), type_size = message.number(2), space_size = message.number(2);
    const std::string_view padded_name = message.take(padded(name_size));
    const std::string name = our_name(padded_name.substr(0, padded_name.find('\0')));
    where_ = fmt::format("{}: attribute {}", name_, name);
    const Type type = type_of(message.take(padded(type_size)));
    const std::vector<std::uint64_t> extent = dimensions(message.take(padded(space_size)));
    if (extent.size() > 1 || (extent.size() == 1 && extent[0] != 1)) {
      refuse(fmt::format("holds {} values (must be one)", fmt::join(extent, " x ")));
    }
    if (!image_.attributes.emplace(name, Hdf5Attribute{type.kind, message.take(type.bytes)}).second) {
      refuse("is there twice");
    }
    where_ = group;
  }

  std::vector<Hdf5Filter> filters(std::string_view bytes) {
    Reading pipeline(bytes, where_);
    pipeline.expect("\x01");
    const std::uint64_t count = pipeline.number(1);
    pipeline.skip(6);
    std::vector<Hdf5Filter> found;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t id = pipeline.number(2), name_size = pipeline.number(2);
      pipeline.skip(2);
      const std::uint64_t numbers = pipeline.number(2);
      pipeline.skip(padded(name_size) + 4 * (numbers + numbers % 2));
      const auto filter = static_cast<Hdf5Filter>(id);
      if (filter != Hdf5Filter::deflate && filter != Hdf5Filter::shuffle && filter != Hdf5Filter::fletcher32) {
        refuse(fmt::format("is packed by filter {} (bitrock uses shuffle, deflate and fletcher32)", id));
      }
      if (std::find(found.begin(), found.end(), filter) != found.end()) refuse("is packed twice by one filter");
      found.push_back(filter);
    }
    return found;
  }

  void where_it_lies(Hdf5Array& made, std::string_view bytes, std::uint64_t count) {
    Reading place(bytes, where_);
    constexpr std::uint64_t contiguous = 1, chunked = 2;
    place.expect("\x03");
    const std::uint64_t kind = place.number(1), width = value_bytes(made.kind);
    if (kind == contiguous) {
      const std::uint64_t address = place.number(8);
      require_possible(count, width, file_.size(), 1);
      if (count > 0) made.chunks.push_back({at(address, count * width), 0});
      if (!made.filters.empty()) refuse("is packed, but not in pieces");
      made.count = made.chunk_count = static_cast<std::size_t>(count);
      return;
    }
    if (kind != chunked) refuse("is stored in a way that bitrock does not use");
    place.expect("\x02");
    const std::uint64_t tree = place.number(8), chunk = place.number(4);
    if (place.number(4) != width || chunk == 0) refuse("is stored in pieces of an impossible size");
    require_possible(count, width, file_.size(), largest_ratio);
    made.count = static_cast<std::size_t>(count);
    made.chunk_count = static_cast<std::size_t>(chunk);
    if (count > 0 && tree != nowhere) chunks(made, tree, width, -1);
    std::uint64_t stored = 0;
    for (const Hdf5Chunk& one : made.chunks) stored += one.bytes.size();
    if (made.chunks.size() != (count + chunk - 1) / chunk) refuse("has pieces that are missing");
    require_possible(made.chunks.size() * chunk, width, stored, made.filters.empty() ? 1 : largest_ratio);
  }

  /// A count is believed when what is stored can hold it.
  void require_possible(std::uint64_t count, std::uint64_t width, std::uint64_t stored, std::uint64_t ratio) {
    if (count / ratio > stored / width + 1) {
      refuse(fmt::format("claims {} values, more than its {} stored bytes can hold", count, stored));
    }
  }

  /// The pieces of an array: B-tree, version 1, whose keys are followed by addresses.
  void chunks(Hdf5Array& made, std::uint64_t address, std::uint64_t width, int level) {
    const Node node = node_head(address, '\x01', level);
    constexpr std::uint64_t key = 4 + 4 + 8 + 8;
    Reading entries(at(address + 24, node.used * (key + 8)), where_);
    for (std::uint64_t i = 0; i < node.used; ++i) {
      const std::uint64_t size = entries.number(4), skipped = entries.number(4), offset = entries.number(8);
      if (entries.number(8) != 0) refuse("has a piece at an impossible place");
      const std::uint64_t child = entries.number(8);
      if (node.level > 0) {
        chunks(made, child, width, node.level - 1);
        continue;
      }
      if (offset != made.chunks.size() * made.chunk_count || offset >= made.count) refuse("has a piece out of place");
      made.chunks.push_back({at(child, size), static_cast<std::uint32_t>(skipped)});
    }
  }

  std::string_view file_;
  const std::string& name_;
  std::string where_;    ///< begins each message
  std::uint64_t means_;  ///< bytes that may still be read
  Hdf5Image image_;
};

}  // namespace

std::size_t value_bytes(Hdf5Kind kind) {
  switch (kind) {
    case Hdf5Kind::byte:
    case Hdf5Kind::text:
      return 1;
    case Hdf5Kind::int32:
    case Hdf5Kind::real32:
      return 4;
    case Hdf5Kind::int64:
    case Hdf5Kind::real64:
      return 8;
  }
  return 1;
}

Hdf5Image hdf5_image(std::string_view bytes, const std::string& name) {
  return Walk(bytes, name).image();
}

}  // namespace bitrock::base
