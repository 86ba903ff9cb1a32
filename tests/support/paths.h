#pragma once
// Purpose: where the tests find the project's sources and what its build made. Only paths.cpp is compiled with these names, so that
// the other objects are the same in every clone and come from the compiler cache.

#include <string>

namespace glisson::test {

std::string sourceFolder();
/// The folder of the built programs.
std::string programFolder();
/// Locales with a decimal comma, made when the build was configured.
std::string localesFolder();
/// The sample patient that the command line's ctest fixtures write.
std::string cliSampleFolder();

}  // namespace glisson::test
