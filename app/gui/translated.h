#pragma once
// Purpose: a widget whose texts follow the language at run time: retranslateUi() is called on every LanguageChange.

#include <QEvent>

namespace glisson {

template <class Base>
class Translated : public Base {
 public:
  using Base::Base;

 protected:
  virtual void retranslateUi() = 0;
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::LanguageChange) {
      retranslateUi();
    }
    Base::changeEvent(event);
  }
};

}  // namespace glisson
