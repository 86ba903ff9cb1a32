#pragma once
// Purpose: file dialogs that begin where the last one ended. They never block the event loop.

#include <QFileDialog>

namespace glisson {

/// Goes when it is closed; the caller sets what may be chosen and opens it.
QFileDialog* makeFileDialog(QWidget* parent, const QString& name, const QString& title);

/// The next dialog begins beside the first of them.
void rememberFolder(const QStringList& paths);

}  // namespace glisson
