#pragma once
// Purpose: messages that stay until they are read: one line each, with a button that puts it away.

#include <QFrame>
#include <QStringList>

#include "app/gui/translated.h"

class QLabel;
class QPushButton;

namespace glisson {

class MessageBar : public Translated<QFrame> {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  /// An English sentence, shown in the language of the window. A message shown already is not shown twice.
  void add(const QString& message);
  [[nodiscard]] const QStringList& messages() const { return messages_; }

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  QStringList messages_;
  QLabel* text_;
  QPushButton* dismiss_;
};

}  // namespace glisson
