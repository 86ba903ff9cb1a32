#pragma once
// Purpose: the one window: puts the parts together and lets them talk. Owns the document; the jobs and the language are given.

#include <QMainWindow>
#include <filesystem>

#include "app/gui/case_opener.h"
#include "app/gui/document.h"
#include "app/gui/language.h"
#include "app/gui/model_builder.h"
#include "app/gui/recent_case.h"
#include "app/gui/translated.h"
#include "app/gui/workspace_bar.h"
#include "reconstruction/evaluation/rated_recipes.h"

class QSplitter;
class QStackedWidget;

namespace glisson {

class ExportPanel;
class JobBar;
class LabWorkspace;
class MainActions;
class MessageBar;
class PlanPanel;
class PlanePlacer;
class StartPage;
class ReportWriter;
class TerritoryEstimator;
class TitleLine;
class ViewArea;

class MainWindow : public Translated<QMainWindow> {
  Q_OBJECT
 public:
  MainWindow(JobRunner& jobs, Language& language, std::filesystem::path recoveryFolder, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Document& document() { return *document_; }
  [[nodiscard]] CaseOpener& opener() { return *opener_; }
  [[nodiscard]] ModelBuilder& builder() { return *builder_; }
  [[nodiscard]] PlanePlacer& placer() { return *placer_; }
  [[nodiscard]] TerritoryEstimator& territories() { return *territories_; }
  [[nodiscard]] ViewArea& views() { return *views_; }
  [[nodiscard]] MessageBar& messages() { return *messages_; }
  [[nodiscard]] ExportPanel& exportPanel() { return *export_; }
  [[nodiscard]] TitleLine& titleLine() { return *title_; }
  [[nodiscard]] Language& language() { return language_; }
  [[nodiscard]] WorkspaceBar& workspaces() { return *workspaces_; }
  [[nodiscard]] LabWorkspace& lab() { return *lab_; }

  // What the menu does.
  void openFiles();
  void openFolder();
  void save();
  void saveAs();
  /// Says what the CT adds to the file, asks for the file, then writes the copy.
  void saveCopyWithCt();
  /// Asks for a file, then writes the report of the plan worked on; with the patient's name, id and birth date only where asked
  /// for.
  void saveReport(bool withIdentity);
  /// reportWritten() or failed() tells. Throws PlanningError while the numbers are not those of the plan, and as ReportWriter.
  void writeReport(const QString& path, bool withIdentity = false);
  /// Makes models of the case's parenchyma by both methods and opens the window in which they are rated.
  void rateModels();
  /// The same of any structure and any models of it.
  void rateModelsOf(const Structure& structure, const std::vector<RatedRecipe>& recipes, const ExperimentOptions& options);
  void showAbout();
  void showLeftPanel(bool shown);
  void showRightPanel(bool shown);
  void setLanguage(const QString& code);
  void setWindowLevel(double width, double level);

 signals:
  /// An input was refused, a structure or an export failed: also shown in the message bar.
  void failed(const QString& message);
  void reportWritten(const QString& path);
  void recentChanged(const QList<glisson::RecentCase>& cases);

 protected:
  void retranslateUi() override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void build();
  void connectParts();
  void onOpened(const Case& content, const std::shared_ptr<CaseFile>& file, const QString& noCt);
  void onCaseChanged();
  void showWorkspace(Workspace workspace);
  void readCtLater();
  void complain(const QString& message);
  void bend(bool shown, bool group);
  void refreshStates();
  void refreshTitle();
  void remember(const QString& path);
  void showRecent();

  JobRunner& jobs_;
  Language& language_;
  std::filesystem::path recoveryFolder_;
  Document* document_;
  CaseOpener* opener_;
  ModelBuilder* builder_;
  TerritoryEstimator* territories_;
  ReportWriter* reports_;
  WorkspaceBar* workspaces_;
  TitleLine* title_;
  MessageBar* messages_;
  QStackedWidget* pages_;  ///< the case with its panels, the lab
  QSplitter* splitter_;
  QWidget* left_;
  QStackedWidget* middle_;
  QStackedWidget* right_;
  StartPage* start_;
  ViewArea* views_;
  PlanPanel* plan_;
  PlanePlacer* placer_;
  ExportPanel* export_;
  LabWorkspace* lab_;
  JobBar* jobBar_;
  MainActions* actions_ = nullptr;
  bool losesEdits_ = false;  ///< the user has said so
  bool leftWanted_ = true;
  bool rightWanted_ = true;
};

}  // namespace glisson
