#include "app/gui/workspace_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

namespace glisson {

WorkspaceBar::WorkspaceBar(QWidget* parent) : Translated<QWidget>(parent), row_(new QHBoxLayout(this)) {
  setObjectName("workspaceBar");
  row_->setContentsMargins(4, 2, 4, 2);
  row_->setSpacing(4);
  auto* group = new QButtonGroup(this);
  constexpr std::array kNames{"workspaceCase", "workspaceModel", "workspacePlan", "workspaceExport", "workspaceCompare"};
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    auto* button = new QToolButton(this);
    button->setObjectName(kNames[i]);
    button->setCheckable(true);
    button->setMinimumWidth(130);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    group->addButton(button);
    if (static_cast<Workspace>(i) == Workspace::Compare) {
      row_->addStretch(1);
    }
    row_->addWidget(button);
    buttons_[i] = button;
    connect(button, &QToolButton::clicked, this, [this, i] {
      current_ = static_cast<Workspace>(i);
      emit chosen(current_);
    });
  }
  row_->addSpacing(8);
  buttons_[0]->setChecked(true);
  retranslateUi();
}

void WorkspaceBar::retranslateUi() {
  const std::array names{tr("Case"), tr("Model"), tr("Plan"), tr("Export"), tr("Compare")};
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    buttons_[i]->setText(names[i] + '\n' + (states_[i].isEmpty() ? QStringLiteral(" ") : states_[i]));
    const bool usable = caseOpen_ || i == 0;
    buttons_[i]->setEnabled(usable);
    buttons_[i]->setToolTip(usable ? QString() : tr("Open a case first."));
  }
}

void WorkspaceBar::setCurrent(Workspace workspace) {
  current_ = workspace;
  buttons_[static_cast<std::size_t>(workspace)]->setChecked(true);
  emit chosen(workspace);
}

void WorkspaceBar::setCaseOpen(bool open) {
  caseOpen_ = open;
  if (!open && current_ != Workspace::Case) {
    setCurrent(Workspace::Case);
  }
  retranslateUi();
}

void WorkspaceBar::setState(Workspace workspace, const QString& state) {
  states_[static_cast<std::size_t>(workspace)] = state;
  retranslateUi();
}

void WorkspaceBar::addAction(QAction* action) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  row_->addWidget(button);
}

}  // namespace glisson
