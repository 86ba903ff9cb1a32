#include "planning/storage/case_file.h"

#include <unistd.h>

#include "planning/storage/case_tables.h"
#include "planning/storage/embedded_ct.h"
#include "planning/storage/history_table.h"
#include "reconstruction/errors.h"
#include "reconstruction/file_lock.h"

namespace glisson {

namespace fs = std::filesystem;

struct CaseFile::Impl {
  // The lock outlives the database: closing a descriptor of the file drops the locks SQLite holds on it.
  FileLock lock;
  Database database;
  mutable caseTables::StoredMeshes meshes;

  Impl(FileLock heldLock, const fs::path& path)
      : lock(std::move(heldLock)), database(path, lock.isWriter() ? Database::Mode::ReadWrite : Database::Mode::ReadOnly) {}

  void requireWriter() const {
    if (!lock.isWriter()) {
      throw InputError(
          database.path().string() +
          " is open read-only, because another program is editing it or it is write-protected; save the case under another name.");
    }
  }
};

namespace {
fs::path journalOf(const fs::path& path) { return path.string() + "-journal"; }

/// Throws where the file is no case of a version this program knows, or damaged.
void check(const Database& database) {
  const std::string file = database.path().string();
  if (database.number("PRAGMA application_id") != caseTables::kApplicationId) {
    throw InputError(file + " is not a Glisson case; choose a .glisson file.");
  }
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version > caseTables::kVersion) {
    throw InputError(file + " was written by a newer Glisson (format " + std::to_string(version) + ", this one reads up to " +
                     std::to_string(caseTables::kVersion) + "); update Glisson to open it.");
  }
  // SQLite fills a last page that is cut short with zeros. A writer may lengthen the file meanwhile, never shorten it.
  const std::int64_t bytes = database.number("PRAGMA page_count") * database.number("PRAGMA page_size");
  const bool whole = static_cast<std::int64_t>(fs::file_size(database.path())) >= bytes;
  Statement statement(database, "PRAGMA quick_check(1)");
  if (version < 1 || !whole || !statement.step() || statement.text(0) != "ok") {
    throw InputError(file + " is damaged or cut short; open an older copy of the case.");
  }
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// The temporary file beside the target; gone unless kept.
class Draft {
 public:
  explicit Draft(const fs::path& target) {
    const std::string begin = "." + target.filename().string() + ".";
    const std::string ending = "XXXXXX";
    removeAbandoned(folderOf(target), [&](const std::string& name) {
      return name.starts_with(begin) && name.size() == begin.size() + ending.size();
    });
    // Another program that tidies up may take the new file for an abandoned one before it is locked.
    constexpr int kTries = 8;
    for (int n = 0; n < kTries && !lock_.holds(path_); ++n) {
      std::string name = (target.parent_path() / (begin + ending)).string();
      const int descriptor = ::mkstemp(name.data());
      if (descriptor < 0) {
        throw InputError(target.string() + " cannot be written; check that its folder is there and that you may write to it.");
      }
      ::close(descriptor);
      path_ = name;
      lock_ = FileLock(path_);
    }
  }
  ~Draft() {
    std::error_code ignored;
    if (!kept_) {
      fs::remove(path_, ignored);
    }
    fs::remove(journalOf(path_), ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

  FileLock takeLock() { return std::move(lock_); }

  void renameTo(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) {
      throw InputError(target.string() + " cannot be written (" + error.message() + "); save the case under another name.");
    }
    kept_ = true;
  }

 private:
  fs::path path_;
  FileLock lock_;
  bool kept_ = false;
};

/// A journal that a killed program left beside the old file would be played into the new one. Opening the old file uses it up.
void settleJournal(const fs::path& path) {
  if (!fs::exists(journalOf(path))) {
    return;
  }
  try {
    (void)Database(path, Database::Mode::ReadWrite).number("SELECT count(*) FROM sqlite_master");
  } catch (const InputError&) {  // whatever it was, it is about to be replaced
  }
  std::error_code ignored;
  fs::remove(journalOf(path), ignored);
}
}  // namespace

CaseFile::CaseFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CaseFile::~CaseFile() = default;
CaseFile::CaseFile(CaseFile&&) noexcept = default;
CaseFile& CaseFile::operator=(CaseFile&&) noexcept = default;

CaseFile CaseFile::create(const fs::path& path, const Case& source, const std::vector<EditStep>& history, const CtStorage& ct,
                          const ExecutionContext& context) {
  if (!source.segmentation || !source.liver) {
    throw PlanningError("A case without a segmentation cannot be saved; open one first.");
  }
  if (ct.embed && !source.ct) {
    throw PlanningError("The case shows no CT that could be embedded; open it where its CT lies.");
  }
  const FileLock replaced(path);
  if (replaced.isOpen() && !replaced.isWriter()) {
    throw InputError(path.string() +
                     " is being edited by another program or is write-protected; save the case under another name.");
  }
  caseTables::StoredMeshes meshes;
  Draft draft(path);
  {
    const Database database(draft.path(), Database::Mode::Create);
    // Nobody sees the draft before it is complete: it needs no journal, and is synchronised once, below.
    database.execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; BEGIN");
    caseTables::createTables(database);
    const Database* earlier = ct.earlier != nullptr ? &ct.earlier->impl_->database : nullptr;
    caseTables::writeCase(database, source, meshes, {earlier, ct.known});
    caseTables::writeHistory(database, history);
    if (ct.embed) {
      caseTables::writeEmbeddedCt(database, *source.ct, context);
    } else if (earlier != nullptr) {
      caseTables::copyEmbeddedCt(*earlier, database);
    }
    database.execute("COMMIT");
  }
  syncToDisk(draft.path());
  FileLock lock = draft.takeLock();
  settleJournal(path);
  draft.renameTo(path);
  syncToDisk(folderOf(path));
  auto impl = std::make_unique<Impl>(std::move(lock), path);
  impl->meshes = std::move(meshes);
  return CaseFile(std::move(impl));
}

CaseFile CaseFile::open(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw InputError(path.string() + " is not a file; choose a .glisson file.");
  }
  FileLock lock(path);
  while (lock.isOpen() && !lock.holds(path) && fs::exists(path, error)) {
    lock = FileLock(path);  // replaced by a new file just now
  }
  if (!lock.isOpen()) {
    throw InputError(path.string() + " cannot be opened; check that you may read it.");
  }
  auto impl = std::make_unique<Impl>(std::move(lock), path);
  check(impl->database);
  return CaseFile(std::move(impl));
}

Case CaseFile::load() const {
  impl_->database.execute("BEGIN");  // one state, even while another program writes the next
  try {
    Case read = caseTables::readCase(impl_->database, impl_->meshes);
    impl_->database.execute("COMMIT");
    return read;
  } catch (...) {
    impl_->database.execute("ROLLBACK");
    throw;
  }
}

void CaseFile::store(const CaseChanges& changes) {
  impl_->requireWriter();
  const Database& database = impl_->database;
  caseTables::StoredMeshes meshes = impl_->meshes;
  Transaction transaction(database);
  bool changed = false;
  if (changes.plans != nullptr) {
    changed = caseTables::writePlans(database, *changes.plans, changes.planEdit);
  }
  if (changes.patient != nullptr) {
    changed = caseTables::writePatient(database, *changes.patient, changes.patientEdit) || changed;
  }
  if (changes.territories != nullptr) {
    changed = caseTables::writeTerritories(database, *changes.territories, changes.territoryEdit) || changed;
  }
  if (changes.model != nullptr) {
    caseTables::editModel(database, *changes.model, meshes, {changes.modelEdit, changes.modelGoesOn});
    changed = true;
  }
  if (changed) {
    transaction.commit();
    impl_->meshes = std::move(meshes);
  }
}

void CaseFile::storePlans(const std::vector<ResectionPlan>& plans, const std::string& name) {
  store({.plans = &plans, .planEdit = name});
}

void CaseFile::storePatient(const PatientFacts& facts, const std::string& name) { store({.patient = &facts, .patientEdit = name}); }

void CaseFile::storeTerritories(const TerritoryMarks& marks, const std::string& name) {
  store({.territories = &marks, .territoryEdit = name});
}

void CaseFile::storeModel(const LiverModel& model, const std::string& name) { store({.model = &model, .modelEdit = name}); }

std::vector<EditStep> CaseFile::history(std::size_t atMost) const { return caseTables::readHistory(impl_->database, atMost); }

bool CaseFile::ctUnchanged() const {
  const std::string source = caseTables::readCtSource(impl_->database);
  const std::vector<CtFileHash> known = ctFiles();
  try {
    return known == hashCtFiles(source);
  } catch (const InputError&) {  // a file that may not be read is not known to be the one it was
    return false;
  }
}

std::vector<CtFileHash> CaseFile::ctFiles() const { return caseTables::readCtFiles(impl_->database); }

bool CaseFile::hasEmbeddedCt() const { return caseTables::hasEmbeddedCt(impl_->database); }

std::shared_ptr<const CtVolume> CaseFile::embeddedCt(const ExecutionContext& context) const {
  if (!hasEmbeddedCt()) {
    return nullptr;
  }
  const auto [labels, identity] = caseTables::readLabelGrid(impl_->database);
  const std::shared_ptr<CtVolume> ct = caseTables::readEmbeddedCt(impl_->database, labels, context);
  ct->identity = identity;  // no second copy of it is in the file
  ct->source = "embedded in " + path().string();
  return ct;
}

bool CaseFile::readOnly() const { return !impl_->lock.isWriter(); }
const fs::path& CaseFile::path() const { return impl_->database.path(); }

}  // namespace glisson
