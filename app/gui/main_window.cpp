#include "app/gui/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/case_panel.h"
#include "app/gui/compare_window.h"
#include "app/gui/export_panel.h"
#include "app/gui/island_box.h"
#include "app/gui/job_bar.h"
#include "app/gui/lab_workspace.h"
#include "app/gui/main_actions.h"
#include "app/gui/measure_box.h"
#include "app/gui/message_bar.h"
#include "app/gui/model_panel.h"
#include "app/gui/number_text.h"
#include "app/gui/place_menu.h"
#include "app/gui/plan_bar.h"
#include "app/gui/plan_panel.h"
#include "app/gui/plane_editor.h"
#include "app/gui/plane_placer.h"
#include "app/gui/report_writer.h"
#include "app/gui/sentences.h"
#include "app/gui/start_page.h"
#include "app/gui/start_rating.h"
#include "app/gui/structure_list.h"
#include "app/gui/territory_box.h"
#include "app/gui/title_line.h"
#include "app/gui/undo_keys.h"
#include "app/gui/view_area.h"
#include "reconstruction/errors.h"

namespace glisson {

MainWindow::MainWindow(JobRunner& jobs, Language& language, std::filesystem::path recoveryFolder, QWidget* parent)
    : Translated<QMainWindow>(parent),
      jobs_(jobs),
      language_(language),
      recoveryFolder_(std::move(recoveryFolder)),
      document_(new Document(jobs, recoveryFolder_, this)),
      opener_(new CaseOpener(jobs, this)),
      builder_(new ModelBuilder(jobs, *document_, this)),
      territories_(new TerritoryEstimator(jobs, *document_, this)),
      reports_(new ReportWriter(jobs, this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  setMinimumSize(1024, 700);
  build();
  actions_ = new MainActions(*this);
  new UndoKeys(this);
  connectParts();
  const QSettings settings;
  setWindowLevel(settings.value("windowWidth", WindowLevel{}.width).toDouble(),
                 settings.value("windowLevel", WindowLevel{}.level).toDouble());
  onCaseChanged();
  retranslateUi();
}

MainWindow::~MainWindow() = default;

void MainWindow::build() {
  auto* centre = new QWidget(this);
  workspaces_ = new WorkspaceBar(centre);
  title_ = new TitleLine(*document_, centre);
  messages_ = new MessageBar(centre);
  pages_ = new QStackedWidget(centre);
  splitter_ = new QSplitter(Qt::Horizontal, pages_);
  left_ = new StructureList(*document_, splitter_);
  middle_ = new QStackedWidget(splitter_);
  right_ = new QStackedWidget(splitter_);
  start_ = new StartPage(middle_);
  views_ = new ViewArea(*document_, jobs_, middle_);
  middle_->addWidget(start_);
  middle_->addWidget(views_);
  placer_ = new PlanePlacer(jobs_, *document_, *views_, this);
  auto* casePanel = new CasePanel(*document_, right_);
  connect(casePanel, &CasePanel::openRequested, this, &MainWindow::openFiles);
  right_->addWidget(casePanel);
  right_->addWidget(new ModelPanel(*document_, *builder_, right_));
  plan_ = new PlanPanel(jobs_, *document_, *territories_, right_);
  right_->addWidget(plan_);
  export_ = new ExportPanel(*document_, jobs_, right_);
  right_->addWidget(export_);
  right_->setMinimumWidth(286);
  left_->setMinimumWidth(200);
  splitter_->setStretchFactor(1, 1);
  splitter_->setChildrenCollapsible(false);
  splitter_->setSizes({250, 770, 300});
  lab_ = new LabWorkspace(*document_, jobs_, pages_);
  pages_->addWidget(splitter_);
  pages_->addWidget(lab_);
  jobBar_ = new JobBar(jobs_, centre);

  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(workspaces_);
  column->addWidget(title_);
  column->addWidget(messages_);
  column->addWidget(pages_, 1);
  column->addWidget(jobBar_);
  setCentralWidget(centre);
}

void MainWindow::connectParts() {
  connect(workspaces_, &WorkspaceBar::chosen, this, &MainWindow::showWorkspace);
  connect(lab_, &LabWorkspace::refused, this, &MainWindow::complain);
  connect(lab_, &LabWorkspace::ratingRequested, this, &MainWindow::rateModelsOf);
  connect(lab_, &LabWorkspace::written, this,
          [this](const QString& path) { jobBar_->tell(tr("Written: %1").arg(QDir::toNativeSeparators(path))); });
  connect(start_, &StartPage::sampleRequested, opener_, &CaseOpener::openSample);
  connect(start_, &StartPage::openRequested, this, &MainWindow::openFiles);
  connect(start_, &StartPage::recentRequested, this, [this](const QString& path) { opener_->openPaths({path}); });
  connect(opener_, &CaseOpener::opened, this,
          [this](const Case& content, const std::shared_ptr<CaseFile>& file, const QStringList&, const QString& noCt) {
            onOpened(content, file, noCt);
          });
  connect(opener_, &CaseOpener::refused, this, &MainWindow::complain);
  connect(builder_, &ModelBuilder::structureFailed, this, &MainWindow::complain);
  connect(builder_, &ModelBuilder::structureReady, this, [this](const QString& name, double seconds) {
    jobBar_->tell(tr("%1 is ready (%2 s).").arg(name, numberText(seconds, 1)));
  });
  connect(builder_, &ModelBuilder::changed, this, &MainWindow::refreshStates);
  connect(document_, &Document::caseChanged, this, &MainWindow::onCaseChanged);
  connect(document_, &Document::modelChanged, this, &MainWindow::refreshStates);
  connect(document_, &Document::planChanged, this, &MainWindow::refreshStates);
  connect(document_, &Document::ctChanged, this, &MainWindow::refreshStates);
  connect(document_, &Document::cleanChanged, this, &MainWindow::refreshTitle);
  connect(document_, &Document::storeFailed, this, &MainWindow::complain);
  connect(document_, &Document::saved, this, [this](const QString& path) {
    remember(path);
    jobBar_->tell(tr("Saved: %1").arg(QDir::toNativeSeparators(path)));
  });
  connect(document_, &Document::copySaved, this,
          [this](const QString& path) { jobBar_->tell(tr("Saved with the CT: %1").arg(QDir::toNativeSeparators(path))); });
  connect(reports_, &ReportWriter::refused, this, &MainWindow::complain);
  connect(reports_, &ReportWriter::written, this, [this](const QString& path) {
    jobBar_->tell(tr("Report written: %1").arg(QDir::toNativeSeparators(path)));
    emit reportWritten(path);
  });
  connect(export_, &ExportPanel::exportFailed, this, &MainWindow::complain);
  connect(export_, &ExportPanel::exported, this, [this](const QString& folder) {
    jobBar_->tell(tr("Exported and verified: %1").arg(QDir::toNativeSeparators(folder)));
    refreshStates();
  });
  connect(&plan_->planBar(), &PlanBar::resectionRequested, placer_, [this] { placer_->addAsSeen(true); });
  connect(&plan_->planBar(), &PlanBar::planeRequested, placer_, [this] { placer_->addAsSeen(false); });
  connect(placer_, &PlanePlacer::placed, this, [this] { workspaces_->setCurrent(Workspace::Plan); });
  connect(placer_, &PlanePlacer::refused, this, &MainWindow::complain);
  connect(placer_, &PlanePlacer::hint, jobBar_, &JobBar::tell);
  connect(&plan_->planBar(), &PlanBar::compareRequested, this, [this] {
    if (document_->content().plans.size() > 1) {
      (new CompareWindow(*document_, views_->displayMeshes(), this))->show();
    }
  });
  connect(&plan_->planBar(), &PlanBar::refused, this, &MainWindow::complain);
  plan_->measureBox().pointIn(views_->modelView());
  connect(&plan_->islandBox(), &IslandBox::chosen, views_, &ViewArea::setCrosshair);
  connect(plan_, &PlanPanel::crossingChosen, views_, &ViewArea::setCrosshair);
  connect(&plan_->islandBox(), &IslandBox::refused, this, &MainWindow::complain);
  plan_->territoryBox().pointIn(views_->modelView());
  connect(&plan_->territoryBox(), &TerritoryBox::hint, jobBar_, &JobBar::tell);
  connect(&plan_->territoryBox(), &TerritoryBox::refused, this, &MainWindow::complain);
  connect(territories_, &TerritoryEstimator::refused, this, &MainWindow::complain);
  connect(&plan_->measureBox(), &MeasureBox::hint, jobBar_, &JobBar::tell);
  connect(&plan_->measureBox(), &MeasureBox::refused, this, &MainWindow::complain);
  PlaneEditor& editor = plan_->planeEditor();
  editor.setPlaceMenu(&placer_->menu());
  connect(&editor, &PlaneEditor::placeRequested, placer_, &PlanePlacer::placeAsSeen);
  connect(&editor, &PlaneEditor::removeRequested, document_, &Document::removePlane);
  connect(&editor, &PlaneEditor::planeEdited, document_, &Document::movePlane);
  connect(&editor, &PlaneEditor::bendingChanged, this, &MainWindow::bend);
  connect(&editor, &PlaneEditor::flattenRequested, document_, &Document::flattenPlane);
  connect(&editor, &PlaneEditor::bendEdited, document_, &Document::bendPlane);
  connect(&editor, &PlaneEditor::controlPointChosen, &views_->modelView(), &ModelView::chooseControlPoint);
  connect(&views_->modelView(), &ModelView::controlPointChosen, &editor, &PlaneEditor::setControlPoint);
  connect(&editor, &PlaneEditor::moveRequested, placer_, &PlanePlacer::moveBy);
  connect(&editor, &PlaneEditor::tiltRequested, placer_, &PlanePlacer::tilt);
  connect(&editor, &PlaneEditor::normalRefused, this,
          [this] { complain(QStringLiteral("The normal (0, 0, 0) has no direction; enter at least one component.")); });
  connect(views_, &ViewArea::windowLevelChanged, this, [](const WindowLevel& windowLevel) {
    QSettings settings;
    settings.setValue("windowWidth", windowLevel.width);
    settings.setValue("windowLevel", windowLevel.level);
  });
  connect(this, &MainWindow::recentChanged, start_, &StartPage::setRecent);
  connect(this, &MainWindow::recentChanged, actions_, &MainActions::setRecent);
}

void MainWindow::bend(bool shown, bool group) {
  views_->modelView().setBending(shown, group);
  if (!shown) {
    return;
  }
  try {
    document_->startBend();
  } catch (const Error& error) {
    complain(messageOf(error));
  }
}

void MainWindow::rateModels() {
  const auto& structures = document_->content().model->structures;
  const auto parenchyma = std::ranges::find(structures, StructureKind::Liver, &Structure::kind);
  if (parenchyma != structures.end()) {
    rateModelsOf(*parenchyma, ratedRecipes({}), {});
  }
}

void MainWindow::rateModelsOf(const Structure& structure, const std::vector<RatedRecipe>& recipes,
                              const ExperimentOptions& options) {
  const QString folder = QString::fromStdString((recoveryFolder_.parent_path() / "ratings").string());
  startRating(jobs_, document_->content(), structure, recipes, options, folder, *this,
              [this](const std::exception& error) { complain(messageOf(error)); });
}

void MainWindow::onOpened(const Case& content, const std::shared_ptr<CaseFile>& file, const QString& noCt) {
  std::error_code ignored;
  if (file && document_->isOpen() && !document_->isReadOnly() &&
      std::filesystem::equivalent(file->path(), document_->path(), ignored)) {
    jobBar_->tell(tr("%1 is open already.").arg(QDir::toNativeSeparators(QString::fromStdString(file->path().string()))));
    return;  // in its place would come the same case without the right to write it
  }
  document_->open(content, file);
  if (file) {
    remember(QString::fromStdString(file->path().string()));
  }
  if (document_->isReadOnly()) {
    messages_->add(
        QStringLiteral(
            "%1 is open in another program or write-protected: changes are kept in a copy of it; save that under another name.")
            .arg(QString::fromStdString(document_->path().string())));
  }
  if (!noCt.isEmpty()) {
    document_->setNoCt(noCt);
  } else if (!content.ct) {
    readCtLater();
  }
  builder_->buildMissing();
  workspaces_->setCurrent(content.plans.empty() || content.plans.front().resections.empty() ? Workspace::Model : Workspace::Plan);
}

void MainWindow::readCtLater() {
  if (document_->content().ctSource.empty()) {
    return;
  }
  JobRequest request{.key = "ct", .title = tr("Reading the CT")};
  const auto stillOpen = [this, code = document_->content().code] { return document_->content().code == code; };
  request.fail = [this, stillOpen](const std::exception& error) {
    if (stillOpen()) {
      document_->setNoCt(messageOf(error));
    }
  };
  submitFor<std::shared_ptr<const CtVolume>>(
      jobs_, std::move(request),
      [content = document_->content()](const ExecutionContext& context) { return readCtOf(content, context); },
      [this, stillOpen](const std::shared_ptr<const CtVolume>& ct) {
        if (stillOpen()) {
          document_->setCt(ct);
        }
      });
}

void MainWindow::onCaseChanged() {
  const bool open = document_->isOpen();
  workspaces_->setCaseOpen(open);
  middle_->setCurrentWidget(open ? static_cast<QWidget*>(views_) : start_);
  left_->setVisible(open && leftWanted_);
  right_->setVisible(open && rightWanted_);
  refreshStates();
  refreshTitle();
}

void MainWindow::showWorkspace(Workspace workspace) {
  if (workspace == Workspace::Compare) {
    pages_->setCurrentWidget(lab_);
    return;
  }
  pages_->setCurrentWidget(splitter_);
  right_->setCurrentIndex(static_cast<int>(workspace));
}

void MainWindow::complain(const QString& message) {
  messages_->add(message);
  emit failed(message);
}

void MainWindow::refreshStates() {
  const bool open = document_->isOpen();
  const int total = builder_->total();
  workspaces_->setState(Workspace::Case,
                        open ? tr("%1 labels").arg(document_->content().segmentation->structures.size()) : tr("open one"));
  workspaces_->setState(Workspace::Model, open ? tr("%1 of %2 made").arg(total - builder_->missing()).arg(total) : QString());
  workspaces_->setState(Workspace::Plan, !open ? QString() : document_->plane() ? tr("plane placed") : tr("no plane yet"));
  workspaces_->setState(Workspace::Export, open ? export_->stateText() : QString());
  workspaces_->setState(Workspace::Compare, open ? tr("methods") : QString());
  actions_->refresh();
  actions_->setPanelsShown(leftWanted_, rightWanted_);
}

void MainWindow::refreshTitle() {
  const QString code =
      document_->isOpen() ? QString::fromStdString(document_->content().code) + QStringLiteral("[*] - ") : QString("[*]");
  setWindowTitle(code + QStringLiteral("Glisson"));
  setWindowModified(!document_->isClean());
}

void MainWindow::retranslateUi() {
  if (actions_ != nullptr) {
    actions_->retranslateUi();
    refreshStates();
    showRecent();  // its texts are of the language
  }
}

void MainWindow::setWindowLevel(double width, double level) { views_->setWindowLevel({width, level}); }

void MainWindow::showLeftPanel(bool shown) {
  leftWanted_ = shown;
  left_->setVisible(shown && document_->isOpen());
}

void MainWindow::showRightPanel(bool shown) {
  rightWanted_ = shown;
  right_->setVisible(shown && document_->isOpen());
}

void MainWindow::setLanguage(const QString& code) {
  QSettings().setValue("language", code);
  language_.use(code);
}

void MainWindow::remember(const QString& path) {
  constexpr int kRemembered = 8;
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  settings.setValue("recent", QStringList(recent.mid(0, kRemembered)));
  showRecent();
}

void MainWindow::showRecent() {
  QList<RecentCase> cases;
  const QDir recovery(QString::fromStdString(recoveryFolder_.string()));
  for (const QFileInfo& file : recovery.entryInfoList({"*.glisson"}, QDir::Files, QDir::Time)) {
    cases.push_back({file.filePath(), file.lastModified()});  // a case that never got a name is not lost
  }
  for (const QString& path : QSettings().value("recent").toStringList()) {
    const auto listed = [&path](const RecentCase& one) { return one.path == path; };
    if (QFileInfo::exists(path) && std::ranges::none_of(cases, listed)) {
      cases.push_back({path, {}});
    }
  }
  emit recentChanged(cases);
}

}  // namespace glisson
