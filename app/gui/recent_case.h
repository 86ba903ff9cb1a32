#pragma once
// Purpose: a case that can be opened again, as the start page and the menu list it.

#include <QDateTime>
#include <QList>
#include <QString>

namespace glisson {

struct RecentCase {
  QString path;
  QDateTime unsaved;  ///< last change of a case that has no name of its own yet; null where it has one

  /// In the language of the window, in one line.
  [[nodiscard]] QString text() const;
};

}  // namespace glisson
