#pragma once
// Purpose: the Model workspace: how each structure was made and how far its surface is from the voxels.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/model_builder.h"
#include "app/gui/translated.h"

class QLabel;
class QPushButton;
class QTextBrowser;

namespace glisson {

class ModelPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  ModelPanel(Document& document, ModelBuilder& builder, QWidget* parent = nullptr);

 protected:
  void retranslateUi() override;

 private:
  void refresh();

  Document& document_;
  ModelBuilder& builder_;
  QPushButton* build_;
  QLabel* summary_;
  QTextBrowser* details_;
};

}  // namespace glisson
