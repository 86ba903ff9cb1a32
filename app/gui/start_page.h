#pragma once
// Purpose: what the empty window shows: the sample patient one click away, the last cases, three steps, what to drop here.

#include <QWidget>

#include "app/gui/recent_case.h"
#include "app/gui/translated.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace glisson {

class StartPage : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecent(const QList<RecentCase>& cases);

 signals:
  void sampleRequested();
  void openRequested();
  void recentRequested(const QString& path);

 protected:
  void retranslateUi() override;

 private:
  QLabel* title_;
  QLabel* subtitle_;
  QPushButton* sample_;
  QPushButton* open_;
  QLabel* steps_;
  QLabel* drop_;
  QLabel* recentTitle_;
  QListWidget* recent_;
};

}  // namespace glisson
