#pragma once
// Purpose: two to four plans of the case side by side: one 3D view each with linked cameras, one table that marks the smallest and
// the largest value of each row, and for two plans what differs in sentences. Shows no best plan. Follows the case.

#include <QWidget>
#include <memory>
#include <vector>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "viewer/model_view.h"

class QHBoxLayout;
class QLabel;
class QToolButton;
class QTreeWidget;

namespace glisson {

class CompareWindow final : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// A window of its own. `ready`: surfaces that need not be made again.
  CompareWindow(Document& document, std::vector<std::shared_ptr<const DisplayMesh>> ready, QWidget* parent);

  [[nodiscard]] const std::vector<ModelView*>& views() const { return views_; }
  /// The plans compared, by place: the first ones of the case until the user chooses.
  void choose(std::vector<std::size_t> plans);

 protected:
  void retranslateUi() override;

 private:
  [[nodiscard]] bool chosenExist() const;
  void refresh();
  void makeViews();
  void showNumbers(const std::vector<PlanAssessment>& assessments);

  Document& document_;
  std::vector<std::shared_ptr<const DisplayMesh>> ready_;
  std::vector<std::size_t> chosen_;
  std::vector<QLabel*> names_;
  std::vector<ModelView*> views_;
  QToolButton* choice_;
  QHBoxLayout* row_;
  QTreeWidget* table_;
  QLabel* differences_;
};

}  // namespace glisson
