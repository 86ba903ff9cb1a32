#pragma once
// Purpose: the report of one plan as a PDF with text that can be selected: numbers with uncertainties, three standard views with
// the cut, planes, parameters, hashes, version; the case's code and the CT's date stand on every page. In the window's language.

#include <QImage>
#include <QString>
#include <array>
#include <optional>

#include "planning/case/case.h"
#include "planning/territories/territory_json.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

struct PlanReport {
  Case content;
  ResectionPlan plan;
  PlanAssessment assessment;                     ///< of this plan
  std::array<QImage, 3> views{};                 ///< from anterior, from superior, from the left
  bool withIdentity = false;                     ///< else the code alone stands for the patient
  std::optional<TerritoryReport> territories{};  ///< of this plan, where they were estimated
};

/// The case holds the patient's name, id or birth date: withIdentity would say something.
bool hasIdentity(const Case& content);

/// An older file at `path` is replaced by a complete one only. Throws InputError where it cannot be written. On any thread.
void writePdf(const PlanReport& report, const QString& path);

}  // namespace glisson
