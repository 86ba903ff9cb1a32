#include "app/gui/recent_case.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace glisson {

QString RecentCase::text() const {
  if (unsaved.isValid()) {
    return QCoreApplication::translate("RecentCase", "Not saved under a name: %1, last changed %2")
        .arg(QFileInfo(path).completeBaseName(), QLocale().toString(unsaved, QLocale::ShortFormat));
  }
  return QFileInfo(path).fileName() + QStringLiteral("   ") + QDir::toNativeSeparators(path);
}

}  // namespace glisson
