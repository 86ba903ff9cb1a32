#include "app/gui/file_dialog.h"

#include <QFileInfo>
#include <QSettings>

namespace glisson {

QFileDialog* makeFileDialog(QWidget* parent, const QString& name, const QString& title) {
  auto* dialog = new QFileDialog(parent, title, QSettings().value("lastFolder").toString());
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  return dialog;
}

void rememberFolder(const QStringList& paths) {
  if (!paths.isEmpty()) {
    QSettings().setValue("lastFolder", QFileInfo(paths.front()).absolutePath());
  }
}

}  // namespace glisson
