#include "tests/support/paths.h"

namespace glisson::test {

std::string sourceFolder() { return GLISSON_SOURCE_DIR; }

std::string programFolder() { return GLISSON_BIN_DIR; }

std::string localesFolder() { return GLISSON_TEST_LOCALES; }

std::string cliSampleFolder() { return GLISSON_CLI_SAMPLE; }

}  // namespace glisson::test
