#pragma once
// Purpose: the line that always says whose liver this is: name, id, birth date, CT date, phase, case code. A switch hides the
// person for pictures; the code stays. An old CT carries a notice.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QLabel;
class QToolButton;

namespace glisson {

/// A CT older than this carries a notice.
inline constexpr int kOldCtDays = 42;

class TitleLine : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit TitleLine(Document& document, QWidget* parent = nullptr);
  void setIdentityHidden(bool hidden);
  [[nodiscard]] bool identityHidden() const;
  [[nodiscard]] QString text() const;

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  Document& document_;
  QLabel* code_;
  QLabel* identity_;
  QLabel* age_;
  QToolButton* hide_;
};

}  // namespace glisson
