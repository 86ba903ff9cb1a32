#pragma once
// Purpose: a question that only a person can answer, before something doubtful is done. Never blocks the event loop; Cancel is
// always there and is what Enter means.

#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace glisson {

struct Question {
  QString name;  ///< objectName
  QString title;
  QString text;     ///< what would follow
  QString details;  ///< what was found
};

struct Answer {
  QString name;  ///< objectName of its button; may be empty
  QString text;
  std::function<void()> act;
};

void ask(QWidget* parent, const Question& question, const std::vector<Answer>& answers);

}  // namespace glisson
