#include "app/gui/undo_keys.h"

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace glisson {

namespace {

/// Where the object takes typed text in one line.
QLineEdit* lineOf(QObject* watched) {
  if (auto* box = qobject_cast<QAbstractSpinBox*>(watched)) {
    return box->findChild<QLineEdit*>();
  }
  return qobject_cast<QLineEdit*>(watched);
}

}  // namespace

UndoKeys::UndoKeys(QObject* parent) : QObject(parent) { QCoreApplication::instance()->installEventFilter(this); }

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) {
    return false;
  }
  QLineEdit* line = lineOf(watched);
  if (line == nullptr) {
    return false;
  }
  const auto* key = static_cast<QKeyEvent*>(event);
  if (event->type() == QEvent::KeyPress) {
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      line->setModified(false);  // taken over
    }
    return false;
  }
  const bool ofUndo = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
  if (!ofUndo || line->isModified()) {
    return false;
  }
  event->ignore();  // so it is the window's
  return true;
}

}  // namespace glisson
