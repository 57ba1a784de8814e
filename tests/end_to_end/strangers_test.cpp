// Files from strangers, in the hands of every command that reads them: an error that names what is wrong, exit status
// 2, within a second or so, and nothing left behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "tests/end_to_end/program.hpp"
#include "tests/hostile_hdf5.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

const std::string shipped_run = BITROCK_SOURCE_DIR "/campaigns/paper240/runs/case_123_seed_1.h5";
const std::string cut_case = BITROCK_SOURCE_DIR "/campaigns/cuts/example.toml";
const std::string rock = BITROCK_SOURCE_DIR "/campaigns/rocks/start.toml";

class Strangers : public testing::Test {
 protected:
  const scratch::Folder dir{"strangers"};

  /// `$FILE` stands for the file.
  static std::vector<std::string> readers_of_runs() {
    return {"snapshot $FILE -o $OUT/s.png", "animate $FILE -o $OUT/a.gif", "export vtk $FILE -o $OUT/vtk",
            "peaks $FILE", "report $FILE -o $OUT/r.html"};
  }
  static std::vector<std::string> readers_of_specimens() {
    return {"cut " + cut_case + " --specimen $FILE -o $OUT/c.h5", "lab ucs " + rock + " --specimen $FILE -o $OUT/lab"};
  }

  void expect_refused(std::string command, const fs::path& file, const std::string& words) {
    const auto put = [&command](const std::string& name, const std::string& value) {
      for (std::size_t at = 0; (at = command.find(name)) != std::string::npos;) command.replace(at, name.size(), value);
    };
    put("$FILE", file.string());
    put("$OUT", (dir / "out").string());
    const auto begin = std::chrono::steady_clock::now();
    const program::Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 2) << command << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << command << "\n" << outcome.text << "\nlacks: " << words;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << command;
    std::error_code no_folder;
    for (const auto& entry : fs::recursive_directory_iterator(dir / "out", no_folder))
      EXPECT_TRUE(entry.is_directory()) << command << " left " << entry.path();
  }
  void expect_refused_by_all(const fs::path& file, const std::string& words) {
    for (const std::string& command : readers_of_runs()) expect_refused(command, file, words);
    for (const std::string& command : readers_of_specimens()) expect_refused(command, file, words);
  }
};

TEST_F(Strangers, ManyNumbersWhereOneBelongs) {
  const std::vector<long long> seeds(500, 1);
  for (const char* format : {"bitrock-run", "bitrock-specimen", "bitrock-drill"}) {
    hostile::write(dir / "many.h5", [&](hid_t file) {
      hostile::text_attribute(file, "format", format);
      hostile::attribute(file, "seed", H5T_NATIVE_LLONG, seeds.data(), 500);
    });
    expect_refused_by_all(dir / "many.h5", "attribute seed holds 500 values (must be one)");
  }
}

TEST_F(Strangers, TextsOfVariableLengthAreNotRead) {
  hostile::write(dir / "text.h5", [&](hid_t file) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const char* text = "bitrock-run";
    hostile::attribute(file, "format", type, &text);
    H5Tclose(type);
  });
  expect_refused_by_all(dir / "text.h5", "make the file again with this one");
}

TEST_F(Strangers, WhatIsNoFile) {
  ASSERT_EQ(::mkfifo((dir / "pipe.h5").c_str(), 0600), 0);
  fs::create_symlink(dir / "a.h5", dir / "b.h5");
  fs::create_symlink(dir / "b.h5", dir / "a.h5");
  fs::create_directory(dir / "folder.h5");
  expect_refused_by_all(dir / "pipe.h5", "is a pipe");
  expect_refused_by_all(dir / "a.h5", "Too many levels of symbolic links");
  for (const std::string& command : std::vector<std::string>{"snapshot $FILE -o $OUT/s.png", "peaks $FILE"})
    expect_refused(command, dir / "folder.h5", "is a folder");
  ASSERT_EQ(::mkfifo((dir / "pipe").c_str(), 0600), 0);
  for (const std::string& command : std::vector<std::string>{
           "specimen $FILE -o $OUT/s.h5", "cut $FILE -o $OUT/c.h5", "peaks $FILE", "train $FILE -o $OUT/m.json",
           "predict $FILE --speed-m-per-s 1 --depth-mm 1 --rake-deg 20", "drill run $FILE -o $OUT/d.h5",
           "specimen " + rock + " --from-discs $FILE -o $OUT/s.h5", "campaign run $FILE --dir $OUT",
           "export c $FILE -o $OUT/m.c", "calibrate $FILE -o $OUT/r.toml"})
    expect_refused(command, dir / "pipe", "is a pipe (a file is needed");
}

/// The attributes and arrays of a run, to be written again with some of them changed.
void copy_but(const fs::path& from, const fs::path& to, const std::function<void(hid_t)>& change) {
  base::write_whole(to, hostile::unsealed(from));
  const hid_t file = H5Fopen(to.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  change(file);
  H5Fclose(file);
  base::write_whole(to, hostile::sealed(base::read_whole(to)));
}

template <class Value>
std::function<void(hid_t)> first_of(const char* path, hid_t type, Value value) {
  return [=](hid_t file) {
    const hid_t array = H5Dopen2(file, path, H5P_DEFAULT), space = H5Dget_space(array);
    const hsize_t begin = 0, one = 1;
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &one, nullptr);
    const hid_t single = H5Screate_simple(1, &one, nullptr);
    EXPECT_GE(H5Dwrite(array, type, single, space, H5P_DEFAULT, &value), 0);
    H5Sclose(single);
    H5Sclose(space);
    H5Dclose(array);
  };
}

template <class Value>
std::function<void(hid_t)> attribute_is(const char* name, hid_t type, Value value) {
  return [=](hid_t file) {
    const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(attribute, type, &value), 0);
    H5Aclose(attribute);
  };
}

TEST_F(Strangers, NumbersThatARunCannotHave) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string draw = "snapshot $FILE -o $OUT/s.png";
  const fs::path file = dir / "changed.h5";
  const auto refused = [&](const std::function<void(hid_t)>& change, const std::string& words) {
    copy_but(shipped_run, file, change);
    expect_refused(draw, file, words);
  };
  refused(attribute_is("discs", H5T_NATIVE_LLONG, 2'000'000'000LL), "discs = 2000000000 (must be a whole number from");
  refused(attribute_is("discs", H5T_NATIVE_LLONG, -4LL), "discs = -4 (must be a whole number from 1");
  refused(attribute_is("discs", H5T_NATIVE_LLONG, 3LL), "(must be from 0 to 2)");
  refused(attribute_is("seed", H5T_NATIVE_LLONG, -1LL), "seed = -1 (must be a whole number from 0");
  refused(attribute_is("steps", H5T_NATIVE_LLONG, 0LL), "steps = 0 (must be a whole number from 1");
  refused(attribute_is("step_s", H5T_NATIVE_DOUBLE, 0.0), "step_s = 0 (must be above 0)");
  refused(attribute_is("mean_force_x_N_per_m", H5T_NATIVE_DOUBLE, nan), "mean_force_x_N_per_m = nan (must be finite)");
  refused(first_of("/cracks/mode", H5T_NATIVE_INT, 7), "crack 0: mode 7 (must be 1 or 2)");
  refused(first_of("/cracks/disc_1", H5T_NATIVE_INT, -9), "crack 0: names disc -9");
  refused(first_of("/cracks/x_m", H5T_NATIVE_DOUBLE, nan), "crack 0: a time, place, angle or length");
  refused(first_of("/force/time_s", H5T_NATIVE_DOUBLE, 1e9), "the times of the force samples do not go up");
  refused(first_of("/force/x_N_per_m", H5T_NATIVE_DOUBLE, nan), "a force or time is not a finite number");
  refused(first_of("/frames/last/id", H5T_NATIVE_INT, 1 << 30), "the number of a disc or fragment");
  refused(first_of("/frames/last/fragment", H5T_NATIVE_INT, -1), "the number of a disc or fragment");
  refused(first_of("/frames/last/radius_m", H5T_NATIVE_DOUBLE, -1.0), "a radius is not above 0");
  refused(first_of("/frames/last/time_s", H5T_NATIVE_DOUBLE, nan), "/frames/last/time_s must be one finite number");
}

TEST_F(Strangers, NumbersThatASpecimenCannotHave) {
  const fs::path good = dir / "good.h5", file = dir / "changed.h5";
  ASSERT_EQ(run("specimen " + rock + " --width-mm 12 --height-mm 12 -o " + good.string()).status, 0);
  const std::string load = readers_of_specimens().back();
  const auto refused = [&](const std::function<void(hid_t)>& change, const std::string& words) {
    copy_but(good, file, change);
    expect_refused(load, file, words);
  };
  const double infinite = std::numeric_limits<double>::infinity();
  refused(attribute_is("seed", H5T_NATIVE_LLONG, -1LL), "seed = -1 (must be a whole number from 0");
  refused(attribute_is("width_m", H5T_NATIVE_DOUBLE, 0.0), "width_m = 0 (must be above 0");
  refused(attribute_is("height_m", H5T_NATIVE_DOUBLE, 1e300), "height_m = 1e+300 (must be above 0");
  refused(attribute_is("pressure_Pa", H5T_NATIVE_DOUBLE, infinite), "pressure_Pa = inf (must be finite)");
  for (const double radius : {infinite, 1e-30, 1e30, -1.0})
    refused(first_of("/discs/radius_m", H5T_NATIVE_DOUBLE, radius), "must lie in the box, its radius be");
  refused(first_of("/discs/x_m", H5T_NATIVE_DOUBLE, 1e300), "must lie in the box, its radius be");
  refused(first_of("/discs/radius_m", H5T_NATIVE_DOUBLE, 0.9), "of the smaller radius (at most 0.5)");
  refused(first_of("/joints/disc_2", H5T_NATIVE_INT, 1 << 30), "joint 0 names discs");
  refused(first_of("/joints/disc_1", H5T_NATIVE_INT, -1), "joint 0 names discs");
}

}  // namespace
