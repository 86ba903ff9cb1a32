#include "app/gui/title_line.h"

#include <QDate>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "app/gui/number_text.h"

namespace glisson {

TitleLine::TitleLine(Document& document, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      code_(new QLabel(this)),
      identity_(new QLabel(this)),
      age_(new QLabel(this)),
      hide_(new QToolButton(this)) {
  setObjectName("titleLine");
  code_->setObjectName("titleCode");
  identity_->setObjectName("titleIdentity");
  hide_->setObjectName("hideIdentity");
  hide_->setCheckable(true);
  QFont bold = code_->font();
  bold.setBold(true);
  code_->setFont(bold);
  identity_->setWordWrap(true);  // a long phase takes a second line rather than being cut
  age_->setStyleSheet("color: #c06000;");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  row->addWidget(code_);
  row->addWidget(identity_, 1);
  row->addWidget(age_);
  row->addWidget(hide_);
  connect(hide_, &QToolButton::toggled, this, &TitleLine::refresh);
  connect(&document_, &Document::caseChanged, this, &TitleLine::refresh);
  connect(&document_, &Document::ctChanged, this, &TitleLine::refresh);
  connect(&document_, &Document::cleanChanged, this, &TitleLine::refresh);
  retranslateUi();
}

void TitleLine::retranslateUi() {
  hide_->setText(tr("Hide identity"));
  hide_->setToolTip(tr("Hides the person for pictures; the case's code stays"));
  refresh();
}

void TitleLine::setIdentityHidden(bool hidden) { hide_->setChecked(hidden); }

bool TitleLine::identityHidden() const { return hide_->isChecked(); }

QString TitleLine::text() const { return code_->text() + ' ' + identity_->text(); }

void TitleLine::refresh() {
  const bool open = document_.isOpen();
  hide_->setVisible(open);
  age_->setVisible(false);
  if (!open) {
    code_->setText(tr("No case"));
    identity_->clear();
    return;
  }
  const PatientIdentity& who = document_.content().identity;
  code_->setText(QString::fromStdString(document_.content().code));
  if (hide_->isChecked()) {
    identity_->setText(tr("identity hidden"));
    identity_->setToolTip({});
    return;
  }
  const auto orNone = [](const QString& text) { return text.isEmpty() ? QStringLiteral("-") : text; };
  QString name = QString::fromStdString(who.patientName);
  name.replace('^', QStringLiteral(", "));
  QStringList parts{name.isEmpty() ? tr("no name") : name, tr("id %1").arg(orNone(QString::fromStdString(who.patientId))),
                    tr("born %1").arg(orNone(dateText(who.birthDate))), tr("CT of %1").arg(orNone(dateText(who.studyDate)))};
  if (!who.seriesDescription.empty()) {  // the phase; a bare dash would not say of what
    parts << QString::fromStdString(who.seriesDescription);
  }
  identity_->setText(parts.join(QStringLiteral("  \u00B7  ")));
  identity_->setToolTip(parts.join('\n'));
  const QDate taken = QDate::fromString(QString::fromStdString(who.studyDate), QStringLiteral("yyyyMMdd"));
  const qint64 days = taken.isValid() ? taken.daysTo(QDate::currentDate()) : 0;
  age_->setVisible(days > kOldCtDays);
  age_->setText(tr("CT is %1 days old").arg(QLocale().toString(days)));
}

}  // namespace glisson
