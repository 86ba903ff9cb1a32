#pragma once
// Purpose: the Export workspace: what goes into the navigation package and where it went. The package is written in a job; before,
// structures that deviate from their voxels are named and asked about.

#include <QWidget>

#include "app/gui/document.h"
#include "app/gui/translated.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace glisson {

class ExportPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  ExportPanel(Document& document, JobRunner& jobs, QWidget* parent = nullptr);

  /// Asks for the folder, then writes. Does nothing where refusal() says why.
  void startExport();
  /// As if the user had chosen `directory`.
  void exportTo(const QString& directory);
  /// Why no package can be written now; empty: it can.
  [[nodiscard]] QString refusal() const;
  void refresh();
  /// "not exported", "exported", "out of date": for the workspace line.
  [[nodiscard]] QString stateText() const;

 signals:
  void exported(const QString& folder);
  void exportFailed(const QString& message);

 protected:
  void retranslateUi() override;

 private:
  [[nodiscard]] QStringList deviations() const;
  void markOutOfDate();
  void write(const QString& directory, bool acceptDeviations);

  Document& document_;
  JobRunner& jobs_;
  QPushButton* export_;
  QLabel* plan_;  ///< which one is exported: the one worked on
  QLabel* contents_;
  QCheckBox* stl_;
  QCheckBox* glb_;
  QCheckBox* patientId_;
  QLabel* deviations_;
  QLabel* notAccepted_;
  QLabel* result_;
  QString lastFolder_;
  int changes_ = 0;
  bool outOfDate_ = false;  ///< plan or model have changed since
};

}  // namespace glisson
