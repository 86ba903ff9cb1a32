#pragma once
// Purpose: the future liver remnant beside what is published about it: body surface area, standardised liver volume, the ratios,
// and each threshold beside its own ratio only, with its citation. Information, not advice: nothing here compares, judges or
// colours. Units: mL, m^2, %. Pure. Rules: a ratio is there where its inputs are and the body is an adult's (120 to 220 cm, 30 to
// 250 kg, 1.2 to 2.6 m^2); thresholds are there only where height, weight and liver condition are all known, and only those
// published for that condition. What is left out says why in `reasons`. Source: Mosteller 1987, DuBois 1916 (body surface area),
// Urata 1995, Vauthey 2002 (standardised liver volume); the thresholds' own citations beside them; which condition a threshold is
// for: the table of minimal remnants in J Surg Oncol 2019;119:594.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planning/case/patient_facts.h"
#include "planning/volumetry/assessment.h"

namespace glisson {

double bsaMostellerM2(double heightCm, double weightKg);
double bsaDuBoisM2(double heightCm, double weightKg);
double slvUrataMl(double bsaM2);
double slvVautheyMl(double bsaM2);

enum class FlrRatioKind : std::uint8_t {
  OfFunctionalPercent,  ///< of the functional CT volume
  OfSlvUrataPercent,
  OfSlvVautheyPercent,
  PerBsaMlPerM2,
  PerBodyWeightPercent  ///< at 1 g/mL
};
/// "flrOfFunctionalPercent", "flrOfSlvUrataPercent", "flrOfSlvVautheyPercent", "flrPerBsaMlPerM2", "flrPerBodyWeightPercent".
std::string_view idOf(FlrRatioKind kind);

/// A published number, in the unit of its ratio.
struct FlrThreshold {
  double value = 0;
  std::string_view citation;  ///< "Kishi 2009"
  LiverCondition condition = LiverCondition::Normal;
};

struct FlrRatio {
  FlrRatioKind kind = FlrRatioKind::OfFunctionalPercent;
  double value = 0;
  std::vector<FlrThreshold> thresholds;  ///< of this ratio and the patient's condition
};

/// What is published about a margin of this many millimetres, for the tumour type given.
struct MarginBand {
  double mm = 0;
  std::string_view meaning;
  std::string_view citation;
};

struct FlrCard {
  PatientFacts facts;
  double functionalMl = 0;
  std::optional<double> functionalRemnantMl;  ///< nothing where the plan does not divide the liver
  std::optional<double> bsaMostellerM2;       ///< what the volumes and ratios here use
  std::optional<double> bsaDuBoisM2;
  std::optional<double> slvUrataMl;
  std::optional<double> slvVautheyMl;
  std::vector<FlrRatio> ratios;
  std::vector<MarginBand> marginBands;  ///< empty where the tumour type is not given
  std::vector<std::string> reasons;     ///< one sentence for each thing left out
};

/// Throws PlanningError where the facts are not positive numbers.
FlrCard flrCard(const PatientFacts& facts, const PlanAssessment& assessment);

/// The `flrCard` object of `plan --json`, as text.
std::string toJson(const FlrCard& card);

}  // namespace glisson
