#include "app/gui/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

#include "app/gui/sentences.h"

namespace glisson {

MessageBar::MessageBar(QWidget* parent) : Translated<QFrame>(parent), text_(new QLabel(this)), dismiss_(new QPushButton(this)) {
  setObjectName("messageBar");
  text_->setObjectName("messageText");
  dismiss_->setObjectName("messageDismiss");
  setStyleSheet("#messageBar { background: #ffe9a8; } #messageText { color: #201800; }");
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* icon = new QLabel(this);
  icon->setPixmap(style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(20, 20));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(icon);
  row->addWidget(text_, 1);
  row->addWidget(dismiss_);
  connect(dismiss_, &QPushButton::clicked, this, [this] {
    messages_.removeFirst();
    refresh();
  });
  retranslateUi();
}

void MessageBar::add(const QString& message) {
  if (!message.isEmpty() && !messages_.contains(message)) {
    messages_ << message;
    refresh();
  }
}

void MessageBar::retranslateUi() { refresh(); }

void MessageBar::refresh() {
  setVisible(!messages_.isEmpty());
  text_->setText(messages_.isEmpty() ? QString() : shownSentence(messages_.front()));
  dismiss_->setText(messages_.size() > 1 ? tr("Read (%1 more)").arg(messages_.size() - 1) : tr("Read"));
}

}  // namespace glisson
