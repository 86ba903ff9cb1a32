#pragma once
// Purpose: the distances that the plan keeps: a list, one more by two clicks in the 3D view, and away with the selected one.

#include <QGroupBox>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "viewer/model_view.h"

class QPushButton;
class QTreeWidget;

namespace glisson {

class MeasureBox final : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit MeasureBox(Document& document, QWidget* parent = nullptr);
  /// Where the two points are clicked.
  void pointIn(ModelView& view);

 signals:
  /// What to do next while pointing; empty: done.
  void hint(const QString& text);
  void refused(const QString& sentence);  ///< in English

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  void refreshButtons();
  void keep(const Pick& pick);

  Document& document_;
  ModelView* view_ = nullptr;
  QTreeWidget* list_;
  QPushButton* measure_;
  QPushButton* remove_;
};

}  // namespace glisson
