#pragma once
// Purpose: the line at the top: Case -> Model -> Plan -> Export, each with what is done or next; at its end Compare, undo and redo.

#include <QAction>
#include <QWidget>
#include <array>

#include "app/gui/translated.h"

class QHBoxLayout;
class QToolButton;

namespace glisson {

/// Compare, for engineers, stands apart from the four that follow one another.
enum class Workspace : std::uint8_t { Case, Model, Plan, Export, Compare };
inline constexpr std::size_t kWorkspaceCount = 5;

class WorkspaceBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit WorkspaceBar(QWidget* parent = nullptr);
  void setCurrent(Workspace workspace);
  [[nodiscard]] Workspace current() const { return current_; }
  /// What is done or next there, in a few words.
  void setState(Workspace workspace, const QString& state);
  /// Without a case only Case can be chosen; the others say why.
  void setCaseOpen(bool open);
  /// A button at the right end.
  void addAction(QAction* action);

 signals:
  void chosen(glisson::Workspace workspace);

 protected:
  void retranslateUi() override;

 private:
  std::array<QToolButton*, kWorkspaceCount> buttons_{};
  std::array<QString, kWorkspaceCount> states_;
  QHBoxLayout* row_;
  bool caseOpen_ = false;
  Workspace current_ = Workspace::Case;
};

}  // namespace glisson
