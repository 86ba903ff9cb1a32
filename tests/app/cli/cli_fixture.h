#pragma once
// Purpose: glisson-cli under test, and the sample patient every test of it reads.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reconstruction/json.h"
#include "tests/support/paths.h"
#include "tests/support/run_program.h"

namespace glisson::test {

inline Finished cli(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) {
  return runProgram("glisson-cli", arguments, environment);
}

/// Made by the ctest fixture cli_sample; where a test is started by hand, made on the first call.
inline std::filesystem::path samplePatient() {
  std::filesystem::path folder = cliSampleFolder();
  if (!std::filesystem::exists(folder / "truth.json")) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder.parent_path());
    const Finished made = cli({"sample", folder.string()});
    if (made.exitCode != 0) {
      throw std::runtime_error("glisson-cli sample failed: " + made.err);
    }
  }
  return folder;
}

inline std::string sampleSegmentation() { return (samplePatient() / "segmentation.seg.nrrd").string(); }

/// The complete model of the sample patient, made likewise.
inline std::filesystem::path sampleCase() {
  std::filesystem::path file = std::filesystem::path(cliSampleFolder()).parent_path() / "sample.glisson";
  if (!std::filesystem::exists(file)) {
    const Finished made = cli({"model", sampleSegmentation(), "--ct", (samplePatient() / "dicom").string(), "-o", file.string()});
    if (made.exitCode != 0) {
      throw std::runtime_error("glisson-cli model failed: " + made.err);
    }
  }
  return file;
}

/// Fails with one line on stderr that begins "glisson-cli: " and holds `words`.
inline void expectRefusal(const Finished& finished, int exitCode, const std::string& words) {
  EXPECT_EQ(finished.exitCode, exitCode) << finished.err;
  EXPECT_EQ(finished.err.rfind("glisson-cli: ", 0), 0U) << finished.err;
  EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  EXPECT_NE(finished.err.find(words), std::string::npos) << finished.err;
}

inline std::vector<std::string> keysOf(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) {
    keys.push_back(key);
  }
  return keys;
}

}  // namespace glisson::test
