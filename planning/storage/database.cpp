#include "planning/storage/database.h"

#include <sqlite3.h>

#include <algorithm>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr int kBusyMilliseconds = 5000;

int flagsOf(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::Create:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case Database::Mode::ReadWrite:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::ReadOnly:
      break;
  }
  return SQLITE_OPEN_READONLY;
}
}  // namespace

void Database::Closer::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Database::Database(const std::filesystem::path& path, Mode mode) : path_(path) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &handle, flagsOf(mode) | SQLITE_OPEN_FULLMUTEX, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) {
    fail(code);
  }
  sqlite3_busy_timeout(handle, kBusyMilliseconds);
  // A file of somebody else must not bring its own functions or triggers to run.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  execute("PRAGMA synchronous=FULL");
}

void Database::execute(const char* sql) const {
  const int code = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) {
    fail(code);
  }
}

std::int64_t Database::number(const char* sql) const {
  Statement statement(*this, sql);
  return statement.step() ? statement.number(0) : 0;
}

void Database::fail(int code) const {
  const std::string file = path_.string();
  switch (code & 0xff) {
    case SQLITE_NOTADB:
      throw InputError(file + " is not a Glisson case; choose a .glisson file.");
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
      throw InputError(file + " is damaged or cut short; open an older copy of the case.");
    case SQLITE_FULL:
      throw InputError(file + " cannot be written because the disk is full; free some space, the last saved state is intact.");
    case SQLITE_READONLY:
      throw InputError(file + " is open read-only; save the case under another name to go on editing.");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw InputError(file + " is in use by another program; try again when it has finished.");
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    default:
      break;
  }
  throw InputError(file + " cannot be read or written (" + sqlite3_errstr(code) + "); check the folder, its rights and the disk.");
}

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(const Database& database, const char* sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database.handle(), sql, -1, &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) {
    database.fail(code);
  }
}

Statement& Statement::bind(int at, std::string_view text) {
  sqlite3_bind_text64(statement_.get(), at + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  return *this;
}

Statement& Statement::bind(int at, std::int64_t number) {
  sqlite3_bind_int64(statement_.get(), at + 1, number);
  return *this;
}

Statement& Statement::bind(int at, std::span<const std::byte> bytes) {
  sqlite3_bind_blob64(statement_.get(), at + 1, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    database_.fail(code);
  }
  return code == SQLITE_ROW;
}

std::string Statement::text(int column) const {
  const std::span<const std::byte> data = bytes(column);
  std::string text(data.size(), '\0');
  std::transform(data.begin(), data.end(), text.begin(), [](std::byte b) { return static_cast<char>(b); });
  return text;
}

std::int64_t Statement::number(int column) const { return sqlite3_column_int64(statement_.get(), column); }

std::span<const std::byte> Statement::bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return {static_cast<const std::byte*>(data), data == nullptr ? 0 : static_cast<std::size_t>(size)};
}

Transaction::Transaction(const Database& database) : database_(database) { database.execute("BEGIN IMMEDIATE"); }

Transaction::~Transaction() {
  if (open_) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace glisson
