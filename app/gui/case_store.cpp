#include "app/gui/case_store.h"

#include <utility>

#include "app/jobs/job_runner.h"
#include "reconstruction/errors.h"
#include "reconstruction/parallel.h"

namespace glisson {

struct CaseStore::Worker : public QObject {
  std::shared_ptr<CaseFile> file;

  void goOnIn(const std::filesystem::path& path, const Case& content) {
    const std::vector<EditStep> history = file ? file->history() : std::vector<EditStep>();
    std::filesystem::create_directories(path.parent_path());
    file = std::make_shared<CaseFile>(CaseFile::create(path, content, history, {.earlier = file.get()}));
  }
};

CaseStore::CaseStore(QObject* parent) : QObject(parent), worker_(std::make_unique<Worker>()) {
  worker_->moveToThread(&thread_);
  // It compresses whole models: the window goes first. A thread that gave way once keeps doing so.
  connect(&thread_, &QThread::started, worker_.get(), [] { const BackgroundWork givesWay; });
  thread_.start();
}

CaseStore::~CaseStore() {
  flush();
  thread_.quit();
  thread_.wait();
}

void CaseStore::postEdit(std::function<void(CaseFile&)> work) {
  post([this, work = std::move(work)](Worker& worker) {
    const bool kept = keepsAll_.exchange(false);
    if (!worker.file) {
      throw InputError("The change is in no file: save the case under another name.");
    }
    work(*worker.file);
    keepsAll_ = kept;
  });
}

void CaseStore::post(std::function<void(Worker&)> work) {
  QMetaObject::invokeMethod(
      worker_.get(),
      [this, work = std::move(work)] {
        try {
          work(*worker_);
        } catch (const std::exception& error) {
          emit failed(messageOf(error));  // queued to the UI thread by the receivers' connections
        }
      },
      Qt::QueuedConnection);
}

void CaseStore::countModelsAnew() { models_ = std::make_shared<std::atomic<std::uint64_t>>(0); }

void CaseStore::create(const std::filesystem::path& path, const Case& content) {
  countModelsAnew();
  post([this, path, content](Worker& worker) {
    worker.file.reset();
    worker.goOnIn(path, content);
    keepsAll_ = true;
  });
}

void CaseStore::adopt(std::shared_ptr<CaseFile> file) {
  countModelsAnew();
  post([this, file = std::move(file)](Worker& worker) {
    worker.file = file;
    keepsAll_ = true;
  });
}

void CaseStore::storePlans(const std::vector<ResectionPlan>& plans, const QString& name) {
  postEdit([plans, name = name.toStdString()](CaseFile& file) { file.storePlans(plans, name); });
}

void CaseStore::storePatient(const PatientFacts& facts, const QString& name) {
  postEdit([facts, name = name.toStdString()](CaseFile& file) { file.storePatient(facts, name); });
}

void CaseStore::storeTerritories(const TerritoryMarks& marks, const QString& name) {
  postEdit([marks, name = name.toStdString()](CaseFile& file) { file.storeTerritories(marks, name); });
}

void CaseStore::storeModel(std::shared_ptr<const LiverModel> model) {
  const std::uint64_t mine = ++*models_;
  post([model = std::move(model), models = models_, mine](Worker& worker) {
    if (worker.file && models->load() == mine) {  // else a newer model of the same file waits behind
      worker.file->storeModel(*model);
    }
  });
}

void CaseStore::editModel(std::shared_ptr<const LiverModel> model, const QString& name, bool goesOn) {
  countModelsAnew();  // the model before is stored, too: the edit's record is the difference from it
  postEdit([model = std::move(model), name = name.toStdString(), goesOn](CaseFile& file) {
    file.store({.model = model.get(), .modelEdit = name, .modelGoesOn = goesOn});
  });
}

void CaseStore::withRecord(std::function<void(FileRecord)> then) {
  post([this, then = std::move(then)](Worker& worker) {
    FileRecord record;
    if (worker.file) {
      record = {worker.file->history(), worker.file->ctFiles()};
    }
    QMetaObject::invokeMethod(
        this, [then, record = std::move(record)] { then(record); }, Qt::QueuedConnection);
  });
}

void CaseStore::goOnIn(const std::filesystem::path& path, const Case& content) {
  countModelsAnew();
  post([this, path, content](Worker& worker) {
    worker.goOnIn(path, content);
    keepsAll_ = true;
  });
}

void CaseStore::saveAs(const std::filesystem::path& path, const Case& content, const std::filesystem::path& obsolete) {
  post([this, path, content, obsolete](Worker& worker) {
    worker.goOnIn(path, content);
    keepsAll_ = true;
    if (!obsolete.empty() && obsolete != path) {
      std::error_code ignored;  // a recovery file left behind is no loss
      std::filesystem::remove(obsolete, ignored);
    }
    emit saved(QString::fromStdString(path.string()));
  });
}

void CaseStore::checkpoint() {
  post([this](Worker& worker) {
    if (worker.file) {
      emit saved(QString::fromStdString(worker.file->path().string()));
    }
  });
}

void CaseStore::close(const std::filesystem::path& discarded) {
  countModelsAnew();
  post([discarded](Worker& worker) {
    worker.file.reset();
    if (!discarded.empty()) {
      std::error_code ignored;  // a recovery file left behind is no loss
      std::filesystem::remove(discarded, ignored);
    }
  });
}

void CaseStore::flush() {
  QMetaObject::invokeMethod(
      worker_.get(), [] {}, Qt::BlockingQueuedConnection);
}

}  // namespace glisson
