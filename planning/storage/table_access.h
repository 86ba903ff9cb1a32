#pragma once
// Purpose: rows of a case file's tables: documents with their checksum, packed parts. Private to storage/.
// What is missing or does not match its checksum throws InputError through damaged().

#include <span>
#include <stdexcept>
#include <string>

#include "planning/storage/database.h"
#include "planning/storage/packing.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"

namespace glisson::caseTables {

/// A text that is no UTF-8 (a name from a foreign file) must not make the case impossible to save.
std::string textOf(const Json& json);

[[noreturn]] void damaged(const Database& database, const std::string& what);

void putDocument(const Database& database, const char* key, const std::string& text);
bool hasDocument(const Database& database, const char* key);
std::string documentText(const Database& database, const char* key);

void putPart(const Database& database, const std::string& key, const Packed& packed);

/// What `read` gives; whatever does not fit becomes a sentence about the file.
template <typename Read>
auto readOrDamaged(const Database& database, const std::string& misfit, Read&& read) {
  try {
    return read();
  } catch (const Json::exception&) {
    damaged(database, misfit);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    damaged(database, error.what());
  }
}

template <typename Unpack>
auto getPart(const Database& database, const std::string& key, Unpack&& unpack) {
  Statement statement(database, "SELECT data FROM part WHERE key = ?");
  if (!statement.bind(0, std::string_view(key)).step()) {
    damaged(database, "its " + key + " is missing");
  }
  return unpack(statement.bytes(0));
}

}  // namespace glisson::caseTables
