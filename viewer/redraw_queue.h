#pragma once
// Purpose: views that change together are drawn one in a turn of the event loop, so that the window answers between them. UI
// thread.

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include "viewer/vtk_widget.h"

namespace glisson {

class RedrawQueue : public QObject {
  Q_OBJECT
 public:
  /// The one of this program; goes with it.
  static RedrawQueue& instance();
  /// The view is drawn in a turn of its own, behind those that wait; once, however often it asks.
  void add(VtkWidget* view);

 private:
  explicit RedrawQueue(QObject* parent);
  void drawNext();
  /// This round of the event loop has taken its time already, most likely to paint the window, and this frame has not waited long.
  [[nodiscard]] bool shouldWait();

  QList<QPointer<VtkWidget>> waiting_;
  QElapsedTimer round_;   ///< since the event loop last looked for news
  QElapsedTimer waited_;  ///< since a frame was first put off; invalid where none is
  QTimer turn_;           ///< of 0 ms: fires behind the events that are posted, the painting of the view before among them
};

}  // namespace glisson
