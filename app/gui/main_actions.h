#pragma once
// Purpose: the menus of the window and their keys. Every action is a child of the window with an objectName.

#include <QAction>
#include <QMenu>
#include <QObject>
#include <functional>
#include <vector>

#include "app/gui/recent_case.h"

namespace glisson {

class MainWindow;

class MainActions : public QObject {
  Q_OBJECT
 public:
  explicit MainActions(MainWindow& window);
  void retranslateUi();
  /// Enabled states and the names of the steps to undo.
  void refresh();
  void setRecent(const QList<RecentCase>& cases);
  void setPanelsShown(bool left, bool right);

 private:
  /// Adds an action whose text is translated anew on every change of language: `text` is the English source in this class' context.
  QAction* add(QMenu* menu, const char* name, const char* text, const QKeySequence& key, std::function<void()> act);
  QMenu* addMenu(QMenu* parent, const char* name, const char* text);
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makePlaneMenu();
  void makeLanguageAndHelp();

  struct Text {
    QAction* action;
    const char* source;
  };
  MainWindow& window_;
  std::vector<Text> texts_;
  std::vector<QAction*> needCase_;
  std::vector<QAction*> needPlane_;
  QMenu* recent_ = nullptr;
  QAction* placeOtherwise_ = nullptr;
  QAction* embed_ = nullptr;
  QAction* identity_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* left_ = nullptr;
  QAction* right_ = nullptr;
  QAction* hide_ = nullptr;
  QAction* map_ = nullptr;
  QAction* english_ = nullptr;
  QAction* german_ = nullptr;
};

}  // namespace glisson
