#include "app/gui/lab_columns.h"

#include <QCoreApplication>
#include <array>

#include "app/gui/number_text.h"
#include "app/gui/sentences.h"
#include "app/lab/accuracy_figure.h"

namespace glisson {

namespace {

using Number = std::optional<double>;

template <double (*of)(const ModelMeasures&)>
Number measure(const LabRow& row) {
  return row.model->measures ? Number(of(*row.model->measures)) : std::nullopt;
}

template <ErrorSummary ModelMeasures::*error, double ErrorSummary::*value>
double errorOf(const ModelMeasures& measures) {
  return measures.*error.*value;
}

Number volumeDeviation(const LabRow& row) {
  if (!row.model->measures || !row.model->measures->volumeMl || row.voxelVolumeMl <= 0) {
    return std::nullopt;
  }
  return 100.0 * (*row.model->measures->volumeMl / row.voxelVolumeMl - 1.0);
}

double triangles(const ModelMeasures& m) { return static_cast<double>(m.triangles); }
double curvature(const ModelMeasures& m) { return 1e3 * m.curvature.trimmedPerMm2; }
Number score(const LabRow& row) { return row.score != nullptr ? Number(row.score->score) : std::nullopt; }
Number seconds(const LabRow& row) { return row.model->seconds.total(); }

/// The families' names as app/lab has them.
[[maybe_unused]] constexpr auto kFamilies = std::to_array<const char*>({
    QT_TRANSLATE_NOOP("LabColumn", "PSR"),
    QT_TRANSLATE_NOOP("LabColumn", "MCSD"),
    QT_TRANSLATE_NOOP("LabColumn", "simplified PSR"),
    QT_TRANSLATE_NOOP("LabColumn", "other methods"),
});

using M = ModelMeasures;
using E = ErrorSummary;

constexpr const char* kMean = QT_TRANSLATE_NOOP("LabColumn", "mean");
constexpr const char* kMost = QT_TRANSLATE_NOOP("LabColumn", "95 %");
constexpr const char* kGreatest = QT_TRANSLATE_NOOP("LabColumn", "greatest");
constexpr const char* kPaper = QT_TRANSLATE_NOOP("LabColumn", "Paper error");
constexpr const char* kThere = QT_TRANSLATE_NOOP("LabColumn", "Surface to voxels");
constexpr const char* kBack = QT_TRANSLATE_NOOP("LabColumn", "Voxels to surface");

constexpr auto kColumns = std::to_array<LabColumn>({
    {QT_TRANSLATE_NOOP("LabColumn", "Triangles"), "", "", 0, measure<triangles>},
    {kPaper, kMean, "mm", 3, measure<errorOf<&M::paperErrorMm, &E::mean>>},
    {kPaper, kMost, "mm", 3, measure<errorOf<&M::paperErrorMm, &E::p95>>},
    {kPaper, kGreatest, "mm", 3, measure<errorOf<&M::paperErrorMm, &E::max>>},
    {kThere, kMean, "mm", 3, measure<errorOf<&M::meshToVoxelsMm, &E::mean>>},
    {kThere, kMost, "mm", 3, measure<errorOf<&M::meshToVoxelsMm, &E::p95>>},
    {kThere, kGreatest, "mm", 3, measure<errorOf<&M::meshToVoxelsMm, &E::max>>},
    {kBack, kMean, "mm", 3, measure<errorOf<&M::voxelsToMeshMm, &E::mean>>},
    {kBack, kMost, "mm", 3, measure<errorOf<&M::voxelsToMeshMm, &E::p95>>},
    {kBack, kGreatest, "mm", 3, measure<errorOf<&M::voxelsToMeshMm, &E::max>>},
    {QT_TRANSLATE_NOOP("LabColumn", "Volume deviation"), "", "%", 2, volumeDeviation},
    {QT_TRANSLATE_NOOP("LabColumn", "Curvature K"), "", "10\u207B\u00B3/mm\u00B2", 3, measure<curvature>},
    {QT_TRANSLATE_NOOP("LabColumn", "Time"), "", "s", 2, seconds},
    {QT_TRANSLATE_NOOP("LabColumn", "Score"), "", "", 3, score},
});

}  // namespace

std::span<const LabColumn> labColumns() { return kColumns; }

QString labText(const char* text) { return QCoreApplication::translate("LabColumn", text); }

QString labColumnName(const LabColumn& column) {
  QString name = labText(column.name);
  if (*column.part != '\0') {
    name += QStringLiteral(", ") + labText(column.part);
  }
  return *column.unit == '\0' ? name : QStringLiteral("%1 (%2)").arg(name, QString::fromUtf8(column.unit));
}

QString labValueText(const LabColumn& column, const LabRow& row) {
  const Number value = column.value(row);
  return value ? numberText(*value, column.decimals) : QStringLiteral("-");
}

QString labDefectsText(const EvaluatedModel& model) {
  if (!model.measures) {
    return shownSentence(model.failure);
  }
  QStringList defects;
  for (const std::string& defect : model.measures->defects) {
    defects << shownSentence(defect);
  }
  return defects.isEmpty() ? QCoreApplication::translate("LabColumn", "none") : defects.join(QStringLiteral("; "));
}

QString labFamilyName(ModelFamily family) { return QCoreApplication::translate("LabColumn", lab::lookOf(family).name); }

}  // namespace glisson
