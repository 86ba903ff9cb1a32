#pragma once
// Purpose: the rows of the catalogue of sentences; see sentences.h.

#include <span>

namespace glisson {

/// A sentence with its places %1, %2... in the order of the text. `places` says what each holds; missing letters mean 'f':
///   f  anything, shown as it is (a file, an id)
///   n  a number, shown with the language's decimal sign
///   s  a sentence or a word that has a row of its own, else as f
///   k  a structure's name, see shownName()
/// With a leading '.' the row holds within an s place only: by itself it would fit too much.
struct SentenceRow {
  const char* places;
  const char* text;
  /// What the window says instead, with as many of the places as it needs; null where it says `text`.
  const char* shown = nullptr;
};

std::span<const SentenceRow> dicomSentences();
std::span<const SentenceRow> readingSentences();
std::span<const SentenceRow> modelSentences();
std::span<const SentenceRow> planningSentences();
std::span<const SentenceRow> planSentences();
std::span<const SentenceRow> windowSentences();
std::span<const SentenceRow> knownNames();

}  // namespace glisson
