#include "app/gui/main_actions.h"

#include <QActionGroup>
#include <QDir>
#include <QMenuBar>
#include <QSettings>

#include "app/gui/export_panel.h"
#include "app/gui/main_window.h"
#include "app/gui/number_text.h"
#include "app/gui/place_menu.h"
#include "app/gui/plan_report.h"
#include "app/gui/plane_editor.h"
#include "app/gui/plane_placer.h"
#include "app/gui/title_line.h"
#include "app/gui/view_area.h"

namespace glisson {

namespace {

constexpr double kKeyStepMm = 1.0;
constexpr double kKeyTiltRadians = 0.0349;  // 2 degrees

struct Preset {
  const char* name;
  double width;
  double level;
};
// clinical.md: Slicer, MITK
constexpr std::array kPresets{
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Abdomen"), 350, 40},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Liver"), 400, 30},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Narrow liver"), 150, 30},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Tumour"), 60, 35},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Blood"), 600, 100},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Bone"), 1000, 400},
    Preset{QT_TRANSLATE_NOOP("glisson::MainActions", "Lung"), 1400, -500},
};

}  // namespace

MainActions::MainActions(MainWindow& window) : QObject(&window), window_(window) {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makePlaneMenu();
  makeLanguageAndHelp();
  retranslateUi();
}

QAction* MainActions::add(QMenu* menu, const char* name, const char* text, const QKeySequence& key, std::function<void()> act) {
  auto* action = new QAction(&window_);
  action->setObjectName(name);
  action->setShortcut(key);
  if (act) {
    connect(action, &QAction::triggered, this, [run = std::move(act)] { run(); });
  }
  menu->addAction(action);
  window_.addAction(action);
  texts_.push_back({action, text});
  return action;
}

QMenu* MainActions::addMenu(QMenu* parent, const char* name, const char* text) {
  QMenu* menu = parent == nullptr ? window_.menuBar()->addMenu(QString()) : parent->addMenu(QString());
  menu->setObjectName(name);
  menu->setToolTipsVisible(true);
  texts_.push_back({menu->menuAction(), text});
  return menu;
}

void MainActions::makeFileMenu() {
  QMenu* file = addMenu(nullptr, "menuFile", QT_TR_NOOP("&File"));
  add(file, "actionOpen", QT_TR_NOOP("&Open files..."), QKeySequence::Open, [this] { window_.openFiles(); });
  add(file, "actionOpenFolder", QT_TR_NOOP("Open &folder..."), QKeySequence("Ctrl+Shift+O"), [this] { window_.openFolder(); });
  add(file, "actionSample", QT_TR_NOOP("Open the sample &patient"), {}, [this] { window_.opener().openSample(); });
  recent_ = addMenu(file, "menuRecent", QT_TR_NOOP("&Last cases"));
  file->addSeparator();
  needCase_.push_back(add(file, "actionSave", QT_TR_NOOP("&Save"), QKeySequence::Save, [this] { window_.save(); }));
  needCase_.push_back(
      add(file, "actionSaveAs", QT_TR_NOOP("Save &as..."), QKeySequence("Ctrl+Shift+S"), [this] { window_.saveAs(); }));
  embed_ = add(file, "actionSaveCopyWithCt", QT_TR_NOOP("Save a copy with the &CT..."), {}, [this] { window_.saveCopyWithCt(); });
  needCase_.push_back(add(file, "actionExport", QT_TR_NOOP("&Export package..."), QKeySequence("Ctrl+E"), [this] {
    window_.workspaces().setCurrent(Workspace::Export);
    window_.exportPanel().startExport();
  }));
  needCase_.push_back(
      add(file, "actionReport", QT_TR_NOOP("&Report as PDF..."), QKeySequence("Ctrl+R"), [this] { window_.saveReport(false); }));
  identity_ =
      add(file, "actionReportIdentity", QT_TR_NOOP("Report with the patient's &name..."), {}, [this] { window_.saveReport(true); });
  file->addSeparator();
  add(file, "actionQuit", QT_TR_NOOP("&Quit"), QKeySequence::Quit, [this] { window_.close(); });
}

void MainActions::makeEditMenu() {
  QMenu* edit = addMenu(nullptr, "menuEdit", QT_TR_NOOP("&Edit"));
  undo_ = new QAction(&window_);
  undo_->setObjectName("actionUndo");
  undo_->setShortcut(QKeySequence::Undo);
  redo_ = new QAction(&window_);
  redo_->setObjectName("actionRedo");
  redo_->setShortcut(QKeySequence("Ctrl+Shift+Z"));
  QUndoStack& stack = window_.document().undoStack();
  connect(undo_, &QAction::triggered, &stack, &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &stack, &QUndoStack::redo);
  connect(&stack, &QUndoStack::indexChanged, this, &MainActions::refresh);
  edit->addAction(undo_);
  edit->addAction(redo_);
  window_.workspaces().addAction(undo_);
  window_.workspaces().addAction(redo_);
}

void MainActions::makeViewMenu() {
  QMenu* view = addMenu(nullptr, "menuView", QT_TR_NOOP("&View"));
  left_ = add(view, "actionLeftPanel", QT_TR_NOOP("&Structures"), QKeySequence(Qt::Key_F9), {});
  right_ = add(view, "actionRightPanel", QT_TR_NOOP("&Workspace panel"), QKeySequence(Qt::Key_F10), {});
  hide_ = add(view, "actionHideIdentity", QT_TR_NOOP("&Hide identity"), {}, {});
  map_ = add(view, "actionCutMap", QT_TR_NOOP("&Map of the cut"), QKeySequence(Qt::Key_F8), {});
  for (QAction* action : {left_, right_, hide_, map_}) {
    action->setCheckable(true);
  }
  ModelView& model = window_.views().modelView();
  connect(map_, &QAction::triggered, &model, &ModelView::setMapShown);
  connect(&model, &ModelView::mapShownChanged, this, [this](bool shown) {
    map_->setChecked(shown);
    QSettings().setValue("cutMap", shown);
  });
  model.setMapShown(QSettings().value("cutMap", true).toBool());
  map_->setChecked(model.mapShown());
  connect(left_, &QAction::triggered, &window_, &MainWindow::showLeftPanel);
  connect(right_, &QAction::triggered, &window_, &MainWindow::showRightPanel);
  connect(hide_, &QAction::triggered, &window_.titleLine(), &TitleLine::setIdentityHidden);
  add(view, "actionFullScreen", QT_TR_NOOP("F&ull screen"), QKeySequence(Qt::Key_F11),
      [this] { window_.isFullScreen() ? window_.showNormal() : window_.showFullScreen(); });
  view->addSeparator();
  QMenu* from = addMenu(view, "menuViewFrom", QT_TR_NOOP("3D seen &from"));
  const auto look = [this, from](const char* name, const char* text, ModelView::StandardView direction) {
    add(from, name, text, {}, [this, direction] { window_.views().modelView().setStandardView(direction); });
  };
  look("viewAnterior", QT_TR_NOOP("Anterior (1)"), ModelView::StandardView::Anterior);
  look("viewLeft", QT_TR_NOOP("Left (3)"), ModelView::StandardView::Left);
  look("viewSuperior", QT_TR_NOOP("Superior (7)"), ModelView::StandardView::Superior);
  look("viewPosterior", QT_TR_NOOP("Posterior"), ModelView::StandardView::Posterior);
  look("viewRight", QT_TR_NOOP("Right"), ModelView::StandardView::Right);
  look("viewInferior", QT_TR_NOOP("Inferior"), ModelView::StandardView::Inferior);
  QMenu* levels = addMenu(view, "menuWindowLevel", QT_TR_NOOP("&CT window"));
  for (const Preset& preset : kPresets) {
    add(levels, preset.name, preset.name, {}, [this, preset] { window_.setWindowLevel(preset.width, preset.level); });
  }
  view->addSeparator();
  needCase_.push_back(add(view, "actionRating", QT_TR_NOOP("&Blind rating of models..."), {}, [this] { window_.rateModels(); }));
}

void MainActions::makePlaneMenu() {
  QMenu* plane = addMenu(nullptr, "menuPlane", QT_TR_NOOP("&Plane"));
  needCase_.push_back(add(plane, "actionPlacePlane", QT_TR_NOOP("&Place plane on the liver"), QKeySequence("P"),
                          [this] { window_.placer().placeAsSeen(); }));
  placeOtherwise_ = plane->addMenu(&window_.placer().menu());
  const auto step = [this, plane](const char* name, const char* text, const char* key, std::function<void()> act) {
    needPlane_.push_back(add(plane, name, text, QKeySequence(key), std::move(act)));
  };
  step("actionMoveForward", QT_TR_NOOP("Move 1 mm to the &resected side"), "+", [this] { window_.placer().moveBy(kKeyStepMm); });
  step("actionMoveBack", QT_TR_NOOP("Move 1 mm to the re&mnant"), "-", [this] { window_.placer().moveBy(-kKeyStepMm); });
  step("actionTiltLeft", QT_TR_NOOP("Turn &left"), "Alt+Left", [this] { window_.placer().tilt(kKeyTiltRadians, 0); });
  step("actionTiltRight", QT_TR_NOOP("Turn ri&ght"), "Alt+Right", [this] { window_.placer().tilt(-kKeyTiltRadians, 0); });
  step("actionTiltUp", QT_TR_NOOP("Turn &up"), "Alt+Up", [this] { window_.placer().tilt(0, kKeyTiltRadians); });
  step("actionTiltDown", QT_TR_NOOP("Turn &down"), "Alt+Down", [this] { window_.placer().tilt(0, -kKeyTiltRadians); });
  step("actionSpinLeft", QT_TR_NOOP("&Spin about its normal"), "Alt+Home",
       [this] { window_.views().modelView().spinPlane(kKeyTiltRadians); });
  step("actionSpinRight", QT_TR_NOOP("Spin &back"), "Alt+End", [this] { window_.views().modelView().spinPlane(-kKeyTiltRadians); });
  plane->addSeparator();
  step("actionRemovePlane", QT_TR_NOOP("Remo&ve plane"), "Ctrl+Del", [this] { window_.document().removePlane(); });
}

void MainActions::makeLanguageAndHelp() {
  QMenu* language = addMenu(nullptr, "menuLanguage", QT_TR_NOOP("&Language"));
  auto* group = new QActionGroup(this);
  english_ = new QAction(QStringLiteral("English"), &window_);  // each language is named in itself
  german_ = new QAction(QStringLiteral("Deutsch"), &window_);
  english_->setObjectName("actionEnglish");
  german_->setObjectName("actionGerman");
  for (QAction* action : {english_, german_}) {
    action->setCheckable(true);
    group->addAction(action);
    language->addAction(action);
  }
  connect(english_, &QAction::triggered, this, [this] { window_.setLanguage("en"); });
  connect(german_, &QAction::triggered, this, [this] { window_.setLanguage("de"); });
  QMenu* help = addMenu(nullptr, "menuHelp", QT_TR_NOOP("&Help"));
  add(help, "actionAbout", QT_TR_NOOP("&About Glisson"), {}, [this] { window_.showAbout(); });
}

void MainActions::retranslateUi() {
  for (const Text& text : texts_) {
    text.action->setText(tr(text.source));
  }
  placeOtherwise_->setText(tr("Place plane &otherwise"));
  english_->setChecked(window_.language().code() != QLatin1String("de"));
  german_->setChecked(window_.language().code() == QLatin1String("de"));
  refresh();
}

void MainActions::refresh() {
  QUndoStack& stack = window_.document().undoStack();
  const auto name = [](QAction& action, bool can, const QString& plain, const QString& step, const QString& nothing) {
    action.setEnabled(can);
    action.setText(can ? plain + QStringLiteral(": ") + Document::stepName(step) : plain);
    action.setIconText(plain);
    action.setToolTip(can ? action.text() : nothing);
  };
  name(*undo_, stack.canUndo(), tr("Undo"), stack.undoText(), tr("There is nothing to undo."));
  name(*redo_, stack.canRedo(), tr("Redo"), stack.redoText(), tr("There is nothing to redo."));
  const bool open = window_.document().isOpen();
  for (QAction* action : needCase_) {
    action->setEnabled(open);
    action->setToolTip(open ? QString() : tr("Open a case first."));
  }
  const bool ct = open && window_.document().content().ct != nullptr;
  embed_->setEnabled(ct);
  embed_->setToolTip(ct ? QString() : open ? tr("The case shows no CT.") : tr("Open a case first."));
  const bool named = open && hasIdentity(window_.document().content());
  identity_->setEnabled(named);
  identity_->setToolTip(named  ? tr("Name, id and birth date stand in it; otherwise the case's code alone stands for the patient.")
                        : open ? tr("The case holds neither name, id nor birth date of the patient.")
                               : tr("Open a case first."));
  const bool plane = window_.document().plane().has_value();
  for (QAction* action : needPlane_) {
    action->setEnabled(plane);
    action->setToolTip(plane ? QString() : tr("Place a plane first."));
  }
  hide_->setChecked(window_.titleLine().identityHidden());
}

void MainActions::setRecent(const QList<RecentCase>& cases) {
  recent_->clear();
  for (const RecentCase& one : cases) {
    const QString text = one.unsaved.isValid() ? one.text() : QDir::toNativeSeparators(one.path);
    connect(recent_->addAction(text), &QAction::triggered, this, [this, path = one.path] { window_.opener().openPaths({path}); });
  }
  recent_->setEnabled(!cases.isEmpty());
}

void MainActions::setPanelsShown(bool left, bool right) {
  left_->setChecked(left);
  right_->setChecked(right);
}

}  // namespace glisson
