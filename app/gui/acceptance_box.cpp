#include "app/gui/acceptance_box.h"

#include <QAction>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

#include "app/gui/model_builder.h"
#include "app/gui/number_text.h"

namespace glisson {

namespace {

constexpr const char* kReviewer = "reviewer";

/// One line that acceptedNow() takes.
QString cleaned(const QString& typed) {
  constexpr int kLongest = 60;  // of at most three bytes each
  QString name;
  for (const QChar letter : typed.simplified()) {
    if (letter.isPrint()) {
      name += letter;
    }
  }
  return name.left(kLongest).trimmed();
}

QString dayOf(const Acceptance& acceptance) {
  std::string day = acceptance.at.substr(0, 10);
  std::erase(day, '-');
  return dateText(day);
}

}  // namespace

AcceptanceBox::AcceptanceBox(Document& document, QWidget& list, QWidget* parent)
    : Translated<QWidget>(parent),
      document_(document),
      button_(new QPushButton(this)),
      accept_(new QAction(&list)),
      acceptAs_(new QAction(&list)),
      acceptAll_(new QAction(&list)),
      withdraw_(new QAction(&list)) {
  setObjectName("acceptanceBox");
  button_->setObjectName("acceptButton");
  accept_->setObjectName("actionAccept");
  acceptAs_->setObjectName("actionAcceptAs");
  acceptAll_->setObjectName("actionAcceptAll");
  withdraw_->setObjectName("actionWithdraw");
  list.setContextMenuPolicy(Qt::ActionsContextMenu);
  list.addActions({accept_, acceptAs_, acceptAll_, withdraw_});
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(button_);
  connect(accept_, &QAction::triggered, this, [this] { accept({id_}); });
  connect(acceptAs_, &QAction::triggered, this, [this] { askName({id_}); });
  connect(acceptAll_, &QAction::triggered, this, [this] { accept(open()); });
  connect(withdraw_, &QAction::triggered, this, [this] { document_.withdrawAcceptance(id_); });
  connect(button_, &QPushButton::clicked, this, [this] { (withdraw_->isEnabled() ? withdraw_ : accept_)->trigger(); });
  connect(&document_, &Document::caseChanged, this, &AcceptanceBox::refresh);
  connect(&document_, &Document::modelChanged, this, &AcceptanceBox::refresh);
  retranslateUi();
}

void AcceptanceBox::setStructure(const std::string& id) {
  id_ = id;
  refresh();
}

void AcceptanceBox::retranslateUi() {
  accept_->setText(tr("Accept"));
  acceptAs_->setText(tr("Accept as..."));
  acceptAll_->setText(tr("Accept all that nobody has accepted"));
  withdraw_->setText(tr("Withdraw acceptance"));
  refresh();
}

void AcceptanceBox::refresh() {
  const Structure* structure = document_.content().model ? document_.content().model->find(id_) : nullptr;
  const bool built = structure != nullptr && structure->reconstruction;
  const bool accepted = built && structure->acceptance;
  accept_->setEnabled(built);
  acceptAs_->setEnabled(built);
  withdraw_->setEnabled(accepted);
  acceptAll_->setEnabled(!open().empty());
  button_->setEnabled(built);
  button_->setText(accepted ? withdraw_->text() : accept_->text());
  button_->setToolTip(structure == nullptr ? tr("Select a structure in the list first.")
                      : !built             ? tr("It has no surface yet.")
                                           : acceptanceText(*structure));
}

std::vector<std::string> AcceptanceBox::open() const {
  std::vector<std::string> ids;
  if (document_.content().model) {
    for (const Structure& structure : document_.content().model->structures) {
      if (structure.reconstruction && !structure.acceptance) {
        ids.push_back(structure.id);
      }
    }
  }
  return ids;
}

void AcceptanceBox::accept(const std::vector<std::string>& ids) {
  const QString name = cleaned(QSettings().value(kReviewer).toString());
  if (name.isEmpty()) {
    askName(ids);
  } else {
    document_.accept(ids, name.toStdString());
  }
}

void AcceptanceBox::askName(const std::vector<std::string>& ids) {
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("reviewerDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Accept"));
  dialog->setLabelText(tr("Your name. It stands beside what you accept, in the case, the report and the package:"));
  dialog->setTextValue(QSettings().value(kReviewer).toString());
  connect(dialog, &QInputDialog::textValueSelected, this, [this, ids](const QString& typed) {
    const QString name = cleaned(typed);
    if (!name.isEmpty()) {
      QSettings().setValue(kReviewer, name);
      document_.accept(ids, name.toStdString());
    }
  });
  dialog->open();
}

QString acceptanceText(const Structure& structure) {
  const std::optional<Acceptance>& acceptance = structure.acceptance;
  return acceptance ? AcceptanceBox::tr("Accepted by %1, %2").arg(QString::fromStdString(acceptance->by), dayOf(*acceptance))
                    : AcceptanceBox::tr("Nobody has accepted it yet.");
}

QString acceptanceCell(const Structure& structure) {
  const std::optional<Acceptance>& acceptance = structure.acceptance;
  return acceptance ? QString::fromStdString(acceptance->by) + QStringLiteral(", ") + dayOf(*acceptance) : QString();
}

}  // namespace glisson
