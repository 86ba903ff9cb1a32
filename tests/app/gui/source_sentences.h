#pragma once
// Finds the sentences that C++ sources make of text literals: "a " + name + (n == 1 ? " b" : " c") is two sentences, "a 7 b" and
// "a 7 c", with a 7 where something is put in. It reads tokens, not the language: enough for expressions joined by +, choices by
// ?:, and constants of the same file.

#include <filesystem>
#include <string>
#include <vector>

namespace glisson::test {

struct SourceSentence {
  int line = 0;
  std::string callee;  ///< the function or type whose argument it is; empty where it is none
  std::string text;
};

/// Every expression that holds a literal of more than one word, and every literal handed to report() as a phase.
std::vector<SourceSentence> sentencesOf(const std::filesystem::path& file);

}  // namespace glisson::test
