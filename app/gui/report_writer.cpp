#include "app/gui/report_writer.h"

#include <QTimer>
#include <array>
#include <utility>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr std::array kViews{ModelView::StandardView::Anterior, ModelView::StandardView::Superior, ModelView::StandardView::Left};
}  // namespace

ReportWriter::ReportWriter(JobRunner& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {}

ReportWriter::~ReportWriter() = default;

void ReportWriter::write(PlanReport report, const std::shared_ptr<const TumourDistance>& tumours,
                         const std::vector<std::shared_ptr<const DisplayMesh>>& ready, const QString& path) {
  if (report.withIdentity && !hasIdentity(report.content)) {
    throw PlanningError("The case holds neither name, id nor birth date of the patient; write the report without them.");
  }
  const bool drawing = view_ != nullptr;
  report_ = std::move(report);
  path_ = path;
  drawn_ = 0;
  view_ = std::make_unique<ModelView>();
  view_->resize(QSize(660, 560) / VtkWidget::kReportTiles);
  view_->setModel(report_.content.model, ready);
  view_->setTumours(tumours);
  view_->setPlan(report_.plan);
  view_->setHandlesShown(false);
  view_->setStandardView(kViews.front());
  if (!drawing) {
    QTimer::singleShot(0, this, &ReportWriter::drawNext);
  }
}

void ReportWriter::drawNext() {
  if (std::optional<QImage> picture = view_->reportPicture()) {
    report_.views[drawn_++] = std::move(*picture);
    if (drawn_ == kViews.size()) {
      view_.reset();
      writeInJob();
      return;
    }
    view_->setStandardView(kViews[drawn_]);
  }
  QTimer::singleShot(0, this, &ReportWriter::drawNext);
}

void ReportWriter::writeInJob() {
  JobRequest request{.key = "report", .title = tr("Report")};
  request.fail = [this](const std::exception& error) { emit refused(messageOf(error)); };
  submitFor<QString>(
      jobs_, std::move(request),
      [report = std::exchange(report_, {}), path = path_](const ExecutionContext& context) {
        context.throwIfCancelled();
        writePdf(report, path);
        return path;
      },
      [this](const QString& path) { emit written(path); });
}

}  // namespace glisson
