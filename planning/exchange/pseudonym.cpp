#include "planning/exchange/pseudonym.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "planning/case/case.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {

bool isWordCharacter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80U; }

/// Words of names that anonymised data bear; in the program's own sentences they name nobody.
constexpr std::array<std::string_view, 5> kNobody{"anonymised", "anonymized", "anonymous", "liver", "patient"};

/// Lower-case words of a text; a DICOM name "Doe^Jane" has two.
std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : toLower(text)) {
    if (isWordCharacter(c)) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) {
    words.pop_back();
  }
  return words;
}

}  // namespace

std::string pseudonymous(const std::string& text, const std::string& fallback, const Case& source) {
  const std::vector<std::string> words = wordsOf(text);
  const std::string lower = toLower(text);
  std::vector<std::string> secrets = wordsOf(source.identity.patientName);
  std::vector<std::string> whole{source.identity.patientId, source.identity.birthDate, source.identity.studyDate,
                                 source.identity.seriesDescription};
  if (source.segmentation) {
    whole.push_back(source.segmentation->patientId);
  }
  for (const std::string& secret : whole) {
    secrets.push_back(toLower(secret));
  }
  constexpr std::size_t kTellingLength = 3;  // shorter parts of a name are found only as whole words
  for (const std::string& secret : secrets) {
    if (secret.empty() || std::ranges::find(kNobody, secret) != kNobody.end()) {
      continue;
    }
    const bool asWord = std::find(words.begin(), words.end(), secret) != words.end();
    if (asWord || (secret.size() >= kTellingLength && lower.find(secret) != std::string::npos)) {
      return fallback;
    }
  }
  return text;
}

}  // namespace glisson
