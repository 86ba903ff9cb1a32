#include "app/gui/question_box.h"

#include <QMessageBox>
#include <QPushButton>

namespace glisson {

void ask(QWidget* parent, const Question& question, const std::vector<Answer>& answers) {
  auto* box = new QMessageBox(QMessageBox::Warning, question.title, question.text, QMessageBox::NoButton, parent);
  box->setObjectName(question.name);
  box->setInformativeText(question.details);
  box->setAttribute(Qt::WA_DeleteOnClose);
  for (const Answer& answer : answers) {
    QPushButton* button = box->addButton(answer.text, QMessageBox::AcceptRole);
    button->setObjectName(answer.name);
    QObject::connect(button, &QPushButton::clicked, parent, answer.act);
  }
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  box->open();
}

}  // namespace glisson
