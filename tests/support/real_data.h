#pragma once
// Purpose: the real patients that some tests read, where they are there, and how long the tests may run.

#include <filesystem>
#include <memory>
#include <string>

#include "tests/support/run_program.h"

namespace glisson::test {

/// The folder of a patient in GLISSON_TEST_DATA (default ../shared/data); it need not exist.
std::filesystem::path realPatient(const std::string& name);

/// `tests/run --all` asks for the long form of a test: GLISSON_LONG_TESTS is set.
bool longRuns();

/// The masks of 3D-IRCADb-01's first patient, unpacked in a temporary folder; null where the patient is not there. Throws
/// std::runtime_error where unzip fails.
std::unique_ptr<TemporaryFolder> unpackedIrcadb01Masks();

}  // namespace glisson::test
