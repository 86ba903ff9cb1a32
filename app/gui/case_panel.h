#pragma once
// Purpose: the Case workspace: what was loaded, which label is what, the problems that were found.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QLabel;
class QListWidget;
class QPushButton;
class QTreeWidget;

namespace glisson {

class CasePanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit CasePanel(Document& document, QWidget* parent = nullptr);

 signals:
  void openRequested();

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  void refreshNotes();

  Document& document_;
  QPushButton* open_;
  QLabel* loaded_;
  QLabel* labelsTitle_;
  QTreeWidget* labels_;
  QLabel* notesTitle_;
  QListWidget* notes_;
};

}  // namespace glisson
