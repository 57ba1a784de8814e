// The HDF5 layer: values, units and attributes come back; equal content gives equal bytes; damage is reported.
#include "base/hdf5_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

std::filesystem::path save(const std::string& name) {
  base::Hdf5Writer writer;
  writer.array("/force/x_N_per_m", std::vector<double>{1.0, -2.5, 1e300}, "N/m", "force");
  writer.array("/force/short", std::vector<float>{1.5F, -2.5F, 3e38F, 1e-40F}, "N/m", "force in 32 bits");
  writer.array("/cracks/mode", std::vector<int>{1, 2}, "1", "mode");
  writer.array("/empty", std::vector<double>{}, "1", "nothing");
  writer.attribute("seed", 7LL);
  writer.attribute("status", "complete");
  static const scratch::Folder folder("hdf5");
  const auto path = folder / name;
  writer.save(path);
  return path;
}

TEST(Hdf5, RoundTrip) {
  const base::Hdf5Reader reader(save("round.h5"));
  EXPECT_EQ(reader.doubles("/force/x_N_per_m"), (std::vector<double>{1.0, -2.5, 1e300}));
  EXPECT_EQ(reader.doubles("/force/short"), (std::vector<double>{1.5, -2.5, 3e38F, 1e-40F}));
  EXPECT_EQ(reader.ints("/cracks/mode"), (std::vector<int>{1, 2}));
  EXPECT_TRUE(reader.doubles("/empty").empty());
  EXPECT_EQ(reader.number_attribute("seed"), 7.0);
  EXPECT_EQ(reader.text_attribute("status"), "complete");
  EXPECT_TRUE(reader.has("/force"));
  EXPECT_FALSE(reader.has("/forc"));
  EXPECT_FALSE(reader.has("/force/none"));
  EXPECT_FALSE(reader.has("/none/none"));
  EXPECT_THROW(reader.doubles("/none"), base::InputError);
}

TEST(Hdf5, TextsOfAnyLengthAndManyValuesComeBack) {
  const scratch::Folder folder("hdf5_long");
  std::string longest;
  for (int k = 0; longest.size() < 200'000; ++k) longest += fmt::format("[[pipe]]\nlength_m = {}\n", k);
  std::vector<double> values;
  for (int k = 0; k < 300'000; ++k) values.push_back(std::sin(k));  // several pieces, hard to pack
  base::Hdf5Writer writer;
  writer.attribute("empty", "");
  writer.attribute("accents", "gr\xc3\xa8s");
  for (const std::size_t length : {1, 59'999, 60'000, 60'001, 200'000})
    writer.attribute(fmt::format("text_{}", length), longest.substr(0, length));
  writer.array("/values", values, "1", "values");
  for (int k = 0; k < 100; ++k) writer.array(fmt::format("/many/{:04d}/x", k), std::vector<int>{k}, "1", "");
  writer.save(folder / "long.h5");
  const base::Hdf5Reader reader(folder / "long.h5");
  EXPECT_EQ(reader.text_attribute("empty"), "");
  EXPECT_EQ(reader.text_attribute("accents"), "gr\xc3\xa8s");
  for (const std::size_t length : {1, 59'999, 60'000, 60'001, 200'000})
    EXPECT_EQ(reader.text_attribute(fmt::format("text_{}", length)), longest.substr(0, length)) << length;
  EXPECT_EQ(reader.doubles("/values"), values);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(reader.ints(fmt::format("/many/{:04d}/x", k)), std::vector<int>{k});
}

TEST(Hdf5, SameContentSameBytes) {
  EXPECT_EQ(base::read_whole(save("one.h5")), base::read_whole(save("two.h5")));
}

TEST(Hdf5, TruncatedAndForeignFilesAreRefused) {
  const auto path = save("cut.h5");
  const std::string bytes = base::read_whole(path);
  base::write_whole(path, bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(base::Hdf5Reader{path}, base::InputError);
  base::write_whole(path, "time,force\n1,2\n");
  EXPECT_THROW(base::Hdf5Reader{path}, base::InputError);
}

TEST(Hdf5, AnyFlippedByteIsNoticedBeforeTheLibrarySeesIt) {
  const auto path = save("flip.h5");
  const std::string bytes = base::read_whole(path);
  EXPECT_NO_THROW(base::Hdf5Reader{path});
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string wrong = bytes;
    wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
    base::write_whole(path, wrong);
    ASSERT_THROW(base::Hdf5Reader{path}, base::InputError) << "byte " << at;
  }
}

TEST(Hdf5, AFileWithoutOurChecksumIsRefused) {
  const auto path = save("foreign.h5");
  const std::string bytes = base::read_whole(path);
  base::write_whole(path, bytes.substr(0, bytes.size() - 24));
  EXPECT_THROW(base::Hdf5Reader{path}, base::InputError);
}

TEST(Hdf5, WritersInSeveralThreadsDoNotDisturbEachOther) {
  const scratch::Folder folder("writers");
  std::vector<std::thread> threads;
  std::atomic<int> failures{0};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&folder, &failures, t] {
      try {
        for (int k = 0; k < 20; ++k) {
          base::Hdf5Writer first, second;  // open at the same time, also within one thread
          first.array("/a", std::vector<double>{1.0 * t}, "1", "a");
          second.array("/a", std::vector<double>{2.0 * t}, "1", "a");
          first.save(folder / fmt::format("{}_{}_1.h5", t, k));
          second.save(folder / fmt::format("{}_{}_2.h5", t, k));
        }
      } catch (const std::exception&) {
        ++failures;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(base::Hdf5Reader(folder / "3_19_2.h5").doubles("/a"), (std::vector<double>{6.0}));
}

}  // namespace
