#pragma once
// Purpose: the keys of Undo and Redo mean the plan, also while a number field has the focus. Qt's fields keep them for what is
// typed in them; here they do so only while something is typed and not yet taken over.

#include <QObject>

namespace glisson {

/// Watches every field of the program as long as it lives.
class UndoKeys : public QObject {
 public:
  explicit UndoKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace glisson
