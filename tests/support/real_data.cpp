#include "tests/support/real_data.h"

#include <cstdlib>
#include <stdexcept>

#include "tests/support/paths.h"

namespace glisson::test {

// NOLINTBEGIN(concurrency-mt-unsafe): nobody sets the environment while tests run
std::filesystem::path realPatient(const std::string& name) {
  const char* root = std::getenv("GLISSON_TEST_DATA");
  return (root != nullptr ? std::filesystem::path(root) : std::filesystem::path(sourceFolder()) / "../shared/data") / name;
}

bool longRuns() { return std::getenv("GLISSON_LONG_TESTS") != nullptr; }

std::unique_ptr<TemporaryFolder> unpackedIrcadb01Masks() {
  const std::filesystem::path zip = realPatient("ircadb01") / "MASKS_DICOM.zip";
  if (!std::filesystem::exists(zip)) {
    return nullptr;
  }
  auto folder = std::make_unique<TemporaryFolder>();
  const std::string unpack = "unzip -q '" + zip.string() + "' -d '" + folder->path().string() + "'";
  if (std::system(unpack.c_str()) != 0) {
    throw std::runtime_error("unzip failed, or is missing");
  }
  return folder;
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace glisson::test
