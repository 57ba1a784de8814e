// Files from strangers behind a right checksum: whatever HDF5 can express and we do not write is refused in words, at
// once, and no byte of another file is read.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "tests/hostile_hdf5.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using Fill = std::function<void(hid_t)>;

class HostileHdf5 : public testing::Test {
 protected:
  const scratch::Folder folder{"hostile_hdf5"};
  const std::filesystem::path path = folder / "hostile.h5";

  /// Opens the file and reads all that it seems to hold.
  static void read_all(const std::filesystem::path& file) {
    const base::Hdf5Reader reader(file);
    reader.text_attribute("format");
    reader.integer_attribute("seed", 0, 1000);
    reader.number_attribute("width_m");
    for (const char* name : {"/g/a", "/a"}) {
      if (reader.has(name)) reader.doubles(name);
    }
  }

  void expect_refused(const Fill& fill, const std::string& words, bool newest = false) {
    hostile::write(
        path,
        [&fill](hid_t file) {
          hostile::text_attribute(file, "format", "bitrock-specimen");
          fill(file);
        },
        newest);
    expect_refused(words);
  }
  void expect_refused(const std::string& words) {
    try {
      read_all(path);
      ADD_FAILURE() << "taken, although: " << words;
    } catch (const base::InputError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(words), std::string::npos) << said << "\n  wanted: " << words;
      EXPECT_TRUE(said.starts_with(path.string())) << said;
    }
  }
};

const std::array<double, 4> four{1.0, 2.0, 3.0, 4.0};

void in_chunks(hid_t list) {
  const hsize_t chunk = 4;
  H5Pset_chunk(list, 1, &chunk);
}

void deflated(hid_t list) {
  in_chunks(list);
  H5Pset_deflate(list, 4);
}

TEST_F(HostileHdf5, AnAttributeHoldsOneValue) {
  const std::vector<long long> many(700, 1);
  expect_refused([&](hid_t file) { hostile::attribute(file, "seed", H5T_NATIVE_LLONG, many.data(), 700); },
                 "attribute seed holds 700 values");
  expect_refused([&](hid_t file) { hostile::attribute(file, "seed", H5T_NATIVE_LLONG, many.data(), 0); },
                 "attribute seed holds 0 values");
  expect_refused(
      [&](hid_t file) {
        const std::array<hsize_t, 2> extent{2, 2};
        const hid_t space = H5Screate_simple(2, extent.data(), nullptr);
        H5Aclose(H5Acreate2(file, "seed", H5T_NATIVE_LLONG, space, H5P_DEFAULT, H5P_DEFAULT));
        H5Sclose(space);
      },
      "attribute seed holds 2 x 2 values");
  hostile::write(path, [&](hid_t file) { hostile::attribute(file, "seed", H5T_NATIVE_LLONG, many.data(), 1); });
  EXPECT_EQ(base::Hdf5Reader(path).integer_attribute("seed", 0, 9), 1) << "one value in a list of one is one value";
}

TEST_F(HostileHdf5, AnAttributeIsANumberOrATextOfFixedLength) {
  expect_refused(
      [](hid_t file) {
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, H5T_VARIABLE);
        const char* text = "granite";
        hostile::attribute(file, "rock", type, &text);
        H5Tclose(type);
      },
      "attribute rock is a text of variable length, as earlier builds of bitrock wrote");
  expect_refused(
      [](hid_t file) {
        const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(double));
        H5Tinsert(type, "x", 0, H5T_NATIVE_DOUBLE);
        hostile::attribute(file, "width_m", type, four.data());
        H5Tclose(type);
      },
      "attribute width_m holds values of a kind that bitrock does not write");
  expect_refused([](hid_t file) { hostile::attribute(file, "seed", H5T_IEEE_F64BE, four.data()); }, "attribute seed");
  expect_refused([](hid_t file) { hostile::text_attribute(file, "seed", "seven"); }, "attribute seed is not a number");
  hostile::write(path, [](hid_t file) { hostile::attribute(file, "format", H5T_NATIVE_DOUBLE, four.data()); });
  expect_refused("attribute format is not text");
}

TEST_F(HostileHdf5, ANumberIsFiniteAndInRange) {
  const auto seed = [](double value) {
    return [value](hid_t file) { hostile::attribute(file, "seed", H5T_NATIVE_DOUBLE, &value); };
  };
  expect_refused(seed(std::nan("")), "seed = nan (must be finite)");
  expect_refused(seed(std::numeric_limits<double>::infinity()), "seed = inf (must be finite)");
  for (const double value : {-1.0, 0.5, 1e300, -1e300, 1001.0})
    expect_refused(seed(value), "(must be a whole number from 0 to 1000)");
  const long long lowest = std::numeric_limits<long long>::min();
  expect_refused([&](hid_t file) { hostile::attribute(file, "seed", H5T_NATIVE_LLONG, &lowest); },
                 "seed = -9223372036854775808 (must be a whole number from 0 to 1000)");
  hostile::write(path, [](hid_t file) {
    const long long large = 9007199254740993;  // the first that no double holds
    hostile::attribute(file, "seed", H5T_NATIVE_LLONG, &large);
  });
  EXPECT_EQ(base::Hdf5Reader(path).integer_attribute("seed", 0, std::numeric_limits<long long>::max()),
            9007199254740993);
}

TEST_F(HostileHdf5, AnArrayHoldsNumbersInOneDimension) {
  const auto of_type = [](hid_t type) { return [type](hid_t file) { hostile::array(file, "/a", type, 4, nullptr); }; };
  const hid_t pair = H5Tcreate(H5T_COMPOUND, 16), list = H5Tvlen_create(H5T_NATIVE_DOUBLE), text = H5Tcopy(H5T_C_S1);
  H5Tinsert(pair, "x", 0, H5T_NATIVE_DOUBLE);
  for (const hid_t type : {pair, list, text, H5T_STD_REF_OBJ, H5T_IEEE_F32BE, H5T_NATIVE_B8, H5T_IEEE_F64BE})
    expect_refused(of_type(type), "/a holds ");
  expect_refused(
      [](hid_t file) {
        const std::array<hsize_t, 2> extent{2, 2};
        const hid_t space = H5Screate_simple(2, extent.data(), nullptr);
        H5Dclose(H5Dcreate2(file, "/a", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        H5Sclose(space);
      },
      "/a must have one dimension");
}

TEST_F(HostileHdf5, ACountIsNoLargerThanWhatIsStored) {
  constexpr hsize_t huge = 8'000'000'000;  // 64 GB
  const auto claimed = [](const Fill& layout) {
    return [layout](hid_t file) { hostile::array(file, "/a", H5T_NATIVE_DOUBLE, huge, nullptr, layout); };
  };
  expect_refused(claimed({}), "/a claims 8000000000 values, more than its");
  expect_refused(claimed(deflated), "/a claims 8000000000 values, more than its");
  expect_refused(claimed([](hid_t list) {
                   const hsize_t chunk = 500'000'000;  // 4 GB
                   H5Pset_chunk(list, 1, &chunk);
                   H5Pset_deflate(list, 9);
                 }),
                 "/a claims 8000000000 values");
  expect_refused([](hid_t file) { hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 100, nullptr, in_chunks); },
                 "/a has pieces that are missing");
  expect_refused(
      [](hid_t file) {
        const hsize_t count = 4, unlimited = H5S_UNLIMITED, chunk = 400'000'000, offset = 0;
        const hid_t space = H5Screate_simple(1, &count, &unlimited), list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(list, 1, &chunk);
        H5Pset_deflate(list, 9);
        const hid_t made = H5Dcreate2(file, "/a", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT);
        H5Pclose(list);
        H5Sclose(space);
        H5Dwrite_chunk(made, H5P_DEFAULT, 0, &offset, sizeof(four), four.data());
        H5Dclose(made);
      },
      "/a claims 400000000 values, more than its 32 stored bytes can hold");
}

TEST_F(HostileHdf5, APieceHoldsWhatItShould) {
  // a deflate stream of 8 bytes of zeros, where four numbers are expected; then no stream at all
  const std::string too_short("\x78\x9c\x63\x60\x80\x00\x00\x00\x08\x00\x01", 11), nonsense(11, 'x');
  for (const std::string& bytes : {too_short, nonsense}) {
    expect_refused(
        [&](hid_t file) {
          const long long seed = 1;
          hostile::attribute(file, "seed", H5T_NATIVE_LLONG, &seed);
          hostile::attribute(file, "width_m", H5T_NATIVE_DOUBLE, four.data());
          hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, nullptr, deflated);
          const hid_t made = H5Dopen2(file, "/a", H5P_DEFAULT);
          const hsize_t offset = 0;
          H5Dwrite_chunk(made, H5P_DEFAULT, 0, &offset, bytes.size(), bytes.data());
          H5Dclose(made);
        },
        "/a cannot be read (damaged: a piece does not hold 4 values)");
  }
}

TEST_F(HostileHdf5, OnlyOurThreeFiltersUnpack) {
  expect_refused(
      [](hid_t file) {
        hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, four.data(), [](hid_t list) {
          in_chunks(list);
          H5Pset_nbit(list);
        });
      },
      "/a is packed by filter 5 ");
  expect_refused(
      [](hid_t file) {
        hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, four.data(), [](hid_t list) {
          deflated(list);
          H5Pset_deflate(list, 4);
        });
      },
      "/a is packed twice by one filter");
}

TEST_F(HostileHdf5, NoOtherFileIsRead) {
  base::write_whole(folder / "secret", std::string(32, 's'));
  hostile::write(folder / "other.h5",
                 [](hid_t file) { hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, four.data()); });
  expect_refused(
      [&](hid_t file) {
        hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, nullptr,
                       [&](hid_t list) { H5Pset_external(list, (folder / "secret").c_str(), 0, 32); });
      },
      "/a holds a message of kind 7, which bitrock does not write (data in another file?)");
  expect_refused(
      [&](hid_t file) {
        hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, nullptr, [&](hid_t list) {
          const hsize_t count = 4;
          const hid_t space = H5Screate_simple(1, &count, nullptr);
          H5Pset_virtual(list, space, (folder / "other.h5").c_str(), "/a", space);
          H5Sclose(space);
        });
      },
      "/a ");
  expect_refused(
      [&](hid_t file) { H5Lcreate_external((folder / "other.h5").c_str(), "/a", file, "a", H5P_DEFAULT, H5P_DEFAULT); },
      "a link of a kind that bitrock does not write");
}

TEST_F(HostileHdf5, LinksAreNotFollowed) {
  expect_refused([](hid_t file) { H5Lcreate_soft("/a", file, "a", H5P_DEFAULT, H5P_DEFAULT); },
                 "holds a as a link (links are not followed)");
  expect_refused([](hid_t file) { H5Lcreate_soft("/", file, "g", H5P_DEFAULT, H5P_DEFAULT); },
                 "holds g as a link (links are not followed)");
  expect_refused([](hid_t file) { H5Lcreate_hard(file, "/", file, "g", H5P_DEFAULT, H5P_DEFAULT); },
                 "overlaps something else");
  expect_refused(
      [](hid_t file) {
        H5L_class_t kind{};
        kind.version = H5L_LINK_CLASS_T_VERS;
        kind.id = static_cast<H5L_type_t>(70);
        kind.trav_func = [](const char*, hid_t, const void*, size_t, hid_t, hid_t) -> hid_t { return -1; };
        H5Lregister(&kind);
        H5Lcreate_ud(file, "a", kind.id, "x", 1, H5P_DEFAULT, H5P_DEFAULT);
      },
      "a link of a kind that bitrock does not write");
}

TEST_F(HostileHdf5, OtherFormsOfTheFormatAreRefused) {
  expect_refused([](hid_t file) { hostile::array(file, "/a", H5T_NATIVE_DOUBLE, 4, four.data()); },
                 "is not what bitrock writes there", true);
  expect_refused(
      [](hid_t file) {
        hid_t group = H5Gopen2(file, "/", H5P_DEFAULT);
        for (int depth = 0; depth < 30; ++depth) {
          const hid_t inner = H5Gcreate2(group, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
          H5Gclose(group);
          group = inner;
        }
        H5Gclose(group);
      },
      "lies deeper than 8 groups");
  expect_refused(
      [](hid_t file) {
        H5Gclose(H5Gcreate2(file, std::string(2000, 'n').c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      },
      "holds a name that bitrock does not write");
  const long long one = 1;
  expect_refused([&](hid_t file) { hostile::attribute(file, "\x1b]0;owned\x07", H5T_NATIVE_LLONG, &one); },
                 "an attribute holds a name that bitrock does not write");
}

/// A small file with everything that ours hold.
std::string good_image(const std::filesystem::path& path) {
  base::Hdf5Writer writer;
  writer.attribute("format", "bitrock-specimen");
  writer.attribute("seed", 7LL);
  writer.attribute("width_m", 0.02);
  writer.attribute("config_toml", "name = \"granite\"\n");
  writer.array("/g/a", std::vector<double>{1.0, -2.5, 1e300}, "N/m", "force");
  writer.array("/a", std::vector<int>{1, 2, 3, 4, 5}, "1", "mode");
  writer.array("/empty", std::vector<double>{}, "1", "nothing");
  writer.save(path);
  return hostile::unsealed(path);
}

/// What a reader would do with these bytes.
void read_image(std::string_view bytes) {
  const base::Hdf5Image image = base::hdf5_image(bytes, "hostile.h5");
  for (const auto& [path, array] : image.arrays) base::hdf5_values(array, path);
}

TEST_F(HostileHdf5, AnyByteMayBeWrongBehindARightChecksum) {
  const std::string image = good_image(path);
  ASSERT_NO_THROW(read_image(image));
  const auto survives = [](const std::string& changed, std::size_t at) {
    try {
      read_image(changed);
    } catch (const base::InputError&) {
      return;
    } catch (const std::exception& error) {
      FAIL() << "byte " << at << ": " << error.what();
    }
  };
  for (std::size_t at = 0; at < image.size(); ++at) {
    for (const int change : {0x01, 0x10, 0x80, 0xff}) {
      std::string changed = image;
      changed[at] = static_cast<char>(changed[at] ^ change);
      survives(changed, at);
    }
  }
  for (std::size_t size = 0; size < image.size(); size += 7) survives(image.substr(0, size), size);
}

}  // namespace
