#pragma once
// Purpose: the little of SQLite that the case file needs: open with the settings of design.md 3.5, statements, transactions.
// Every failure throws InputError with one sentence that names the file.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace glisson {

class Database {
 public:
  enum class Mode : std::uint8_t { Create, ReadWrite, ReadOnly };
  Database(const std::filesystem::path& path, Mode mode);

  void execute(const char* sql) const;
  [[nodiscard]] std::int64_t number(const char* sql) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Throws what SQLite's result code means for this file.
  [[noreturn]] void fail(int code) const;
  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }

 private:
  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

/// One prepared statement; parameters and columns count from 0.
class Statement {
 public:
  Statement(const Database& database, const char* sql);
  Statement& bind(int at, std::string_view text);
  Statement& bind(int at, std::int64_t number);
  Statement& bind(int at, std::span<const std::byte> bytes);
  /// True where there is a row.
  bool step();
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::int64_t number(int column) const;
  /// Valid until the next step.
  [[nodiscard]] std::span<const std::byte> bytes(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
};

/// Rolls back unless committed.
class Transaction {
 public:
  explicit Transaction(const Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace glisson
