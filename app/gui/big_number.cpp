#include "app/gui/big_number.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace glisson {

BigNumber::BigNumber(const QString& objectName, double scale, QWidget* parent)
    : QWidget(parent), caption_(new QLabel(this)), reason_(new QLabel(this)), value_(new QLabel(this)), share_(new QLabel(this)) {
  setObjectName(objectName);
  value_->setObjectName(objectName + "Value");
  share_->setObjectName(objectName + "Share");
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * scale);
  large.setBold(true);
  const QFontMetrics metrics(large);
  for (QLabel* label : {value_, share_}) {
    label->setFont(large);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  value_->setFixedWidth(metrics.horizontalAdvance(QStringLiteral("-0,000 mL")));
  share_->setMinimumWidth(metrics.horizontalAdvance(QStringLiteral("\u2265 -00.0")));
  caption_->setObjectName(objectName + "Caption");
  // the name of a tumour may be long: it takes a second line, and never pushes a number out of the panel
  caption_->setWordWrap(true);
  caption_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  reason_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  reason_->setObjectName(objectName + "Reason");

  auto* captions = new QHBoxLayout;
  captions->addWidget(caption_, 1);
  captions->addWidget(reason_);
  auto* values = new QHBoxLayout;
  values->addWidget(value_);
  values->addWidget(share_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 2);
  column->setSpacing(0);
  column->addLayout(captions);
  column->addLayout(values);
}

void BigNumber::setValue(const QString& value, const QString& share) {
  value_->setText(value);
  share_->setText(share);
}

void BigNumber::setOutOfDate(const QString& reason) {
  outOfDate_ = reason;
  for (QLabel* label : {value_, share_}) {
    QFont font = label->font();
    font.setStrikeOut(!reason.isEmpty());
    label->setFont(font);
  }
  showReason();
}

void BigNumber::setWarning(const QString& reason) {
  warning_ = reason;
  const QString style = reason.isEmpty() ? QString() : QStringLiteral("color: #d02020;");
  for (QLabel* label : {value_, share_, reason_}) {
    label->setStyleSheet(style);
  }
  showReason();
}

void BigNumber::setNote(const QString& note) {
  note_ = note;
  showReason();
}

void BigNumber::showReason() { reason_->setText(!outOfDate_.isEmpty() ? outOfDate_ : !warning_.isEmpty() ? warning_ : note_); }

}  // namespace glisson
