#include "app/gui/start_page.h"

#include <QDir>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace glisson {

StartPage::StartPage(QWidget* parent)
    : Translated<QWidget>(parent),
      title_(new QLabel(this)),
      subtitle_(new QLabel(this)),
      sample_(new QPushButton(this)),
      open_(new QPushButton(this)),
      steps_(new QLabel(this)),
      drop_(new QLabel(this)),
      recentTitle_(new QLabel(this)),
      recent_(new QListWidget(this)) {
  setObjectName("startPage");
  sample_->setObjectName("openSample");
  open_->setObjectName("openFiles");
  recent_->setObjectName("recentList");
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 2.2);
  large.setBold(true);
  title_->setFont(large);
  for (QPushButton* button : {sample_, open_}) {
    button->setMinimumHeight(40);
  }
  for (QLabel* label : {subtitle_, steps_, drop_}) {
    label->setWordWrap(true);
  }
  sample_->setDefault(true);
  recent_->setMaximumHeight(150);
  recent_->setTextElideMode(Qt::ElideMiddle);

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(sample_, 1);
  buttons->addWidget(open_, 1);
  auto* column = new QVBoxLayout;
  column->setSpacing(12);
  column->addStretch(1);
  for (QWidget* part : std::initializer_list<QWidget*>{title_, subtitle_}) {
    column->addWidget(part);
  }
  column->addLayout(buttons);
  for (QWidget* part : std::initializer_list<QWidget*>{drop_, steps_, recentTitle_, recent_}) {
    column->addWidget(part);
  }
  column->addStretch(1);
  auto* row = new QHBoxLayout(this);
  row->addStretch(1);
  row->addLayout(column, 3);
  row->addStretch(1);

  connect(sample_, &QPushButton::clicked, this, &StartPage::sampleRequested);
  connect(open_, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(recent_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { emit recentRequested(item->data(Qt::UserRole).toString()); });
  connect(recent_, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { emit recentRequested(item->data(Qt::UserRole).toString()); });
  retranslateUi();
  setRecent({});
}

void StartPage::retranslateUi() {
  title_->setText(tr("Glisson"));
  subtitle_->setText(tr("Planning of liver resections. Not for clinical use."));
  sample_->setText(tr("Open the sample patient"));
  open_->setText(tr("Open files..."));
  drop_->setText(
      tr("Or drop here: a CT (DICOM folder, NIfTI, NRRD, MetaImage) together with its segmentation, or a .glisson case."));
  steps_->setText(
      tr("1. Open a CT and its segmentation: the model is reconstructed by itself.\n"
         "2. Place the resection plane on the liver and move it: volumes and margins follow.\n"
         "3. Export the package for navigation."));
  recentTitle_->setText(tr("Last cases"));
}

void StartPage::setRecent(const QList<RecentCase>& cases) {
  recent_->clear();
  for (const RecentCase& one : cases) {
    auto* item = new QListWidgetItem(one.text(), recent_);
    item->setData(Qt::UserRole, one.path);
    item->setToolTip(QDir::toNativeSeparators(one.path));
  }
  recent_->setVisible(!cases.isEmpty());
  recentTitle_->setVisible(!cases.isEmpty());
}

}  // namespace glisson
