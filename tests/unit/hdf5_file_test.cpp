// The HDF5 layer: values, units and attributes come back; equal content gives equal bytes; damage is reported.
#include "base/hdf5_file.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

namespace {

std::filesystem::path save(const std::string& name) {
  base::Hdf5Writer writer;
  writer.array("/force/x_N_per_m", std::vector<double>{1.0, -2.5, 1e300}, "N/m", "force");
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
  EXPECT_EQ(reader.ints("/cracks/mode"), (std::vector<int>{1, 2}));
  EXPECT_TRUE(reader.doubles("/empty").empty());
  EXPECT_EQ(reader.number_attribute("seed"), 7.0);
  EXPECT_EQ(reader.text_attribute("status"), "complete");
  EXPECT_FALSE(reader.has("/force/none"));
  EXPECT_FALSE(reader.has("/none/none"));
  EXPECT_THROW(reader.doubles("/none"), base::InputError);
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

TEST(Hdf5, AFlippedByteInAnArrayIsNoticed) {
  const scratch::Folder folder("flip");
  const auto path = folder / "flip.h5";
  std::vector<double> values(20000);
  std::uint64_t state = 1;
  for (double& value : values)
    value = static_cast<double>(state = state * 6364136223846793005ULL + 1442695040888963407ULL);
  base::Hdf5Writer writer;
  writer.array("/values", values, "1", "noise, so that the array is most of the file");
  writer.save(path);
  std::string bytes = base::read_whole(path);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
  base::write_whole(path, bytes);
  EXPECT_THROW(base::Hdf5Reader(path).doubles("/values"), base::InputError);
}

}  // namespace
