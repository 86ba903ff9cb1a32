#pragma once
// Purpose: separated pieces of the plan's two sides, each with a mark that gives it to the other side. Shown only where there are
// any.

#include <QGroupBox>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QTreeWidget;

namespace glisson {

class IslandBox final : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit IslandBox(Document& document, QWidget* parent = nullptr);

 signals:
  void chosen(const glisson::Vec3& pointMm);  ///< a point inside the piece, to look at it
  void refused(const QString& sentence);      ///< in English

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  /// The island of this place in the assessment to the other side, or back.
  void give(int index, bool away);

  Document& document_;
  QTreeWidget* list_;
  bool refreshing_ = false;
};

}  // namespace glisson
