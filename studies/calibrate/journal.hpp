#pragma once
/// What calibration has already tested, in a table beside its result: one row a laboratory test. The same command looks
/// there first, so a calibration that was stopped goes on where it stood, and a second one with other tolerances or
/// targets reuses what it can. Rows of other inputs (rock, core size, engine) are kept and passed over. One program at
/// a time uses a journal.

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "studies/calibrate/properties.hpp"

namespace bitrock::studies {

/// A test that a calibration makes.
struct LaboratoryTest {
  dem2d::LabTest kind = dem2d::LabTest::ucs;  ///< ucs, tension or triaxial
  double pressure = 0.0;                      ///< that confines it; 0 but in a triaxial test [Pa]

  bool operator==(const LaboratoryTest&) const = default;  ///< the same test
};

/// One laboratory test: a row of the table.
struct TestRecord {
  LaboratoryTest test;          ///< that was made
  int seed = 0;                 ///< of the specimen
  Micro micro{};                ///< of its joints
  double peak_stress = 0.0;     ///< [Pa]
  double youngs_modulus = 0.0;  ///< [Pa]
  double poissons_ratio = 0.0;  ///< [1]
  double wall_time = 0.0;       ///< [s]
};

/// The table in memory, and its file, which is locked as long as this lives.
class Journal {
 public:
  /// Reads the table when it is there; an empty file is a new journal. `inputs` is a text on which all that the tests
  /// depend is written, but for micro-parameters and seed. A last row that was cut short is left out. Throws
  /// `base::InputError` when a file of that name is no journal, has another row that no test can have given, or is used
  /// by another program; the file is then as it was.
  Journal(std::filesystem::path path, const std::string& inputs);

  /// The record of exactly these micro-parameters and seed. Safe to call from several threads.
  std::optional<TestRecord> find(const LaboratoryTest& test, int seed, const Micro& micro) const;

  /// Keeps a record: when this returns it is on the disk. Safe to call from several threads.
  void add(const TestRecord& record);

  const std::filesystem::path& path() const { return path_; }  ///< of the table, for messages

  /// What was left out, for the user; empty when nothing was.
  const std::string& left_out() const { return left_out_; }

 private:
  struct Row {
    double inputs;  ///< the first 52 bits of the fingerprint, as a whole number
    TestRecord record;
  };
  void read_rows();

  std::filesystem::path path_;
  base::FileLock lock_;
  double inputs_;
  std::string left_out_;
  std::vector<Row> rows_;
  mutable std::mutex mutex_;
};

}  // namespace bitrock::studies
