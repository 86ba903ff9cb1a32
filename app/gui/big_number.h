#pragma once
// Purpose: one of the numbers that decide: a small caption, a large value and a large share beside it, in fixed widths so that
// nothing jumps while they change. A value out of date is struck, its reason beside it.

#include <QLabel>
#include <QWidget>

namespace glisson {

class BigNumber : public QWidget {
  Q_OBJECT
 public:
  /// `points`: size of the digits relative to the widget's font.
  BigNumber(const QString& objectName, double scale, QWidget* parent = nullptr);

  void setCaption(const QString& caption) { caption_->setText(caption); }
  void setValue(const QString& value, const QString& share);
  /// An empty reason: the value is current.
  void setOutOfDate(const QString& reason);
  /// The value in red with its reason written beside it.
  void setWarning(const QString& reason);
  /// Why there is no value, in plain colour.
  void setNote(const QString& note);
  [[nodiscard]] QString valueText() const { return value_->text(); }
  [[nodiscard]] QString shareText() const { return share_->text(); }

 private:
  void showReason();
  QLabel* caption_;
  QLabel* reason_;
  QLabel* value_;
  QLabel* share_;
  QString outOfDate_;
  QString warning_;
  QString note_;
};

}  // namespace glisson
