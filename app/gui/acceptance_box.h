#pragma once
// Purpose: a person accepts the surface of a structure, or takes it back: a button below the list of structures and entries of its
// context menu. The person's name is asked for once and remembered in the settings.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QAction;
class QPushButton;

namespace glisson {

class AcceptanceBox : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// `list`: gets the context menu.
  AcceptanceBox(Document& document, QWidget& list, QWidget* parent = nullptr);
  /// The structure the button acts on; empty: none.
  void setStructure(const std::string& id);

 protected:
  void retranslateUi() override;

 private:
  void refresh();
  void accept(const std::vector<std::string>& ids);
  void askName(const std::vector<std::string>& ids);
  [[nodiscard]] std::vector<std::string> open() const;

  Document& document_;
  std::string id_;
  QPushButton* button_;
  QAction* accept_;
  QAction* acceptAs_;
  QAction* acceptAll_;
  QAction* withdraw_;
};

/// "Accepted by Dr. A, 2026-01-31", or that nobody has.
QString acceptanceText(const Structure& structure);
/// The same for a table: name and date, or empty.
QString acceptanceCell(const Structure& structure);

}  // namespace glisson
