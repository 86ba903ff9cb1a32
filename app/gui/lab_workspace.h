#pragma once
// Purpose: the Compare workspace: one structure of the case, reconstructed by all methods, as a live scatter plot or a table above
// the two models that are looked at. Nothing here changes the case. Its compare_window.h namesake compares plans.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/gui/document.h"
#include "app/gui/translated.h"
#include "reconstruction/evaluation/rated_recipes.h"

class QTabWidget;

namespace glisson {

class LabExperiment;
class LabPlot;
class LabSetup;
class LabSide;
class LabTable;
class LabViews;

class LabWorkspace : public Translated<QWidget> {
  Q_OBJECT
 public:
  LabWorkspace(Document& document, JobRunner& jobs, QWidget* parent);

  [[nodiscard]] LabExperiment& experiment() { return *experiment_; }
  [[nodiscard]] LabPlot& plot() { return *plot_; }
  [[nodiscard]] LabViews& views() { return *views_; }
  [[nodiscard]] LabSide& side(std::size_t side) { return *sides_[side]; }

  /// Write the table, the plot as a picture, the plot as SVG. Throw InputError where the file cannot be written.
  void writeCsv(const QString& path) const;
  void writePng(const QString& path) const;
  void writeSvg(const QString& path) const;

 signals:
  void refused(const QString& sentence);  ///< in English
  void written(const QString& path);
  /// A blind rating of these models of this structure, made with these options.
  void ratingRequested(const glisson::Structure& structure, const std::vector<glisson::RatedRecipe>& recipes,
                       const glisson::ExperimentOptions& options);

 protected:
  void retranslateUi() override;

 private:
  void build();
  void connectParts();
  void takeSubject();
  void choose(std::size_t place, std::size_t side);
  void showDepth(int depth);
  /// Of a model that the experiment has measured: one that it could not make is the side's own.
  [[nodiscard]] std::optional<std::size_t> measuredPlaceOf(const ModelRecipe& recipe) const;
  void refresh();
  void refreshNumbers();
  /// Asks for a file, then writes it.
  void save(const QString& title, const QString& name, const QString& filter, void (LabWorkspace::*write)(const QString&) const);

  Document& document_;
  LabExperiment* experiment_;
  std::array<LabSide*, 2> sides_;
  LabSetup* setup_;
  QTabWidget* tabs_;
  LabPlot* plot_;
  LabTable* table_;
  LabViews* views_;
};

}  // namespace glisson
