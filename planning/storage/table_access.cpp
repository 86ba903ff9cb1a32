#include "planning/storage/table_access.h"

#include <zlib.h>

#include "reconstruction/errors.h"

namespace glisson::caseTables {

namespace {
std::int64_t crcOf(std::string_view text) {
  return static_cast<std::int64_t>(crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}
}  // namespace

std::string textOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void damaged(const Database& database, const std::string& what) {
  throw InputError(database.path().string() + " is damaged (" + what + "); open an older copy of the case.");
}

void putDocument(const Database& database, const char* key, const std::string& text) {
  Statement statement(database, "INSERT OR REPLACE INTO document(key, json, crc) VALUES(?, ?, ?)");
  statement.bind(0, std::string_view(key)).bind(1, std::string_view(text)).bind(2, crcOf(text)).step();
}

bool hasDocument(const Database& database, const char* key) {
  Statement statement(database, "SELECT 1 FROM document WHERE key = ?");
  return statement.bind(0, std::string_view(key)).step();
}

std::string documentText(const Database& database, const char* key) {
  Statement statement(database, "SELECT json, crc FROM document WHERE key = ?");
  if (!statement.bind(0, std::string_view(key)).step()) {
    damaged(database, std::string("its ") + key + " is missing");
  }
  std::string text = statement.text(0);
  if (crcOf(text) != statement.number(1)) {
    damaged(database, std::string("its ") + key + " does not match its checksum");
  }
  return text;
}

void putPart(const Database& database, const std::string& key, const Packed& packed) {
  Statement statement(database, "INSERT OR REPLACE INTO part(key, data) VALUES(?, ?)");
  statement.bind(0, std::string_view(key)).bind(1, std::span<const std::byte>(packed.data)).step();
}

}  // namespace glisson::caseTables
