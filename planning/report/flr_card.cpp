#include "planning/report/flr_card.h"

#include <array>
#include <cmath>

#include "reconstruction/text.h"

namespace glisson {

namespace {
struct RatioThreshold {
  FlrRatioKind kind;
  FlrThreshold threshold;
};
constexpr auto kThresholds = std::to_array<RatioThreshold>({
    {FlrRatioKind::OfSlvVautheyPercent, {20, "Kishi 2009", LiverCondition::Normal}},
    {FlrRatioKind::OfSlvVautheyPercent, {25, "Vauthey 2000", LiverCondition::Normal}},
    {FlrRatioKind::OfSlvVautheyPercent, {30, "Shindoh 2013", LiverCondition::LongChemotherapy}},
    {FlrRatioKind::OfFunctionalPercent, {25, "Shoup 2003", LiverCondition::Normal}},
    {FlrRatioKind::OfFunctionalPercent, {40, "Azoulay 2000", LiverCondition::Injured}},
    {FlrRatioKind::PerBsaMlPerM2, {250, "Shirabe 1999", LiverCondition::Injured}},
    {FlrRatioKind::PerBodyWeightPercent, {0.5, "Truant 2007", LiverCondition::Normal}},
});

struct TypeBand {
  TumourType type;
  MarginBand band;
};
const auto kBands = std::to_array<TypeBand>({
    {TumourType::ColorectalMetastases, {1, "below this: R1; from this on: accepted", "Sakamoto 2023"}},
    {TumourType::ColorectalMetastases, {10, "the old rule", "Poultsides 2010"}},
    {TumourType::HepatocellularCarcinoma, {5, "below this: worse, in non-anatomical resections", "Dong 2016"}},
});

struct CardRange {
  double low;
  double high;
  [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
};
constexpr CardRange kHeightCm{120, 220};
constexpr CardRange kWeightKg{30, 250};
constexpr CardRange kBsaM2{1.2, 2.6};

bool isAdult(const std::optional<double>& value, const CardRange& range) { return value && range.holds(*value); }

/// Why there is no standardised liver volume: what is missing first, then what is no adult's.
void explainBody(const PatientFacts& facts, std::vector<std::string>& reasons) {
  if (!facts.heightCm) {
    reasons.emplace_back("The height is not given, so no standardised liver volume and no threshold is shown.");
  } else if (!kHeightCm.holds(*facts.heightCm)) {
    reasons.push_back("A height of " + formatExact(*facts.heightCm) +
                      " cm is outside 120 to 220 cm, for which the formulas hold, so no standardised liver volume and no threshold "
                      "is shown.");
  }
  if (!facts.weightKg) {
    reasons.emplace_back("The weight is not given, so no standardised liver volume and no threshold is shown.");
  } else if (!kWeightKg.holds(*facts.weightKg)) {
    reasons.push_back(
        "A weight of " + formatExact(*facts.weightKg) +
        " kg is outside 30 to 250 kg, for which the formulas hold, so no standardised liver volume and no threshold is "
        "shown.");
  }
}

void addBody(FlrCard& card) {
  explainBody(card.facts, card.reasons);
  if (!isAdult(card.facts.heightCm, kHeightCm) || !isAdult(card.facts.weightKg, kWeightKg)) {
    return;
  }
  const double bsa = bsaMostellerM2(*card.facts.heightCm, *card.facts.weightKg);
  if (!kBsaM2.holds(bsa)) {
    card.reasons.push_back("A body surface area of " + formatNumber(bsa, 2) +
                           " m2 is outside 1.2 to 2.6 m2, for which the formulas hold, so no standardised liver volume and no "
                           "threshold is shown.");
    return;
  }
  card.bsaMostellerM2 = bsa;
  card.bsaDuBoisM2 = bsaDuBoisM2(*card.facts.heightCm, *card.facts.weightKg);
  card.slvUrataMl = slvUrataMl(bsa);
  card.slvVautheyMl = slvVautheyMl(bsa);
}

void addRatios(FlrCard& card) {
  const double flr = *card.functionalRemnantMl;
  if (card.functionalMl > 0) {
    card.ratios.push_back({FlrRatioKind::OfFunctionalPercent, 100 * flr / card.functionalMl, {}});
  }
  if (card.bsaMostellerM2) {
    card.ratios.push_back({FlrRatioKind::OfSlvUrataPercent, 100 * flr / *card.slvUrataMl, {}});
    card.ratios.push_back({FlrRatioKind::OfSlvVautheyPercent, 100 * flr / *card.slvVautheyMl, {}});
    card.ratios.push_back({FlrRatioKind::PerBsaMlPerM2, flr / *card.bsaMostellerM2, {}});
  }
  if (isAdult(card.facts.weightKg, kWeightKg)) {
    card.ratios.push_back({FlrRatioKind::PerBodyWeightPercent, flr / (10 * *card.facts.weightKg), {}});
  }
}

void addThresholds(FlrCard& card) {
  if (!card.facts.condition) {
    card.reasons.emplace_back("The liver's condition is not given, so no threshold is shown.");
    return;
  }
  if (!card.bsaMostellerM2) {
    return;  // said above
  }
  for (FlrRatio& ratio : card.ratios) {
    for (const RatioThreshold& known : kThresholds) {
      if (known.kind == ratio.kind && known.threshold.condition == *card.facts.condition) {
        ratio.thresholds.push_back(known.threshold);
      }
    }
  }
  if (*card.facts.condition == LiverCondition::Injured) {
    card.reasons.emplace_back(
        "Kubota's 40 or 50 % of the functional volume depend on ICG R15, which is not asked for, so they are "
        "not shown.");
  }
}
}  // namespace

double bsaMostellerM2(double heightCm, double weightKg) { return std::sqrt(heightCm * weightKg / 3600); }
double bsaDuBoisM2(double heightCm, double weightKg) { return 0.007184 * std::pow(heightCm, 0.725) * std::pow(weightKg, 0.425); }
double slvUrataMl(double bsaM2) { return 706.2 * bsaM2 + 2.4; }
double slvVautheyMl(double bsaM2) { return 1267.28 * bsaM2 - 794.41; }

FlrCard flrCard(const PatientFacts& facts, const PlanAssessment& assessment) {
  validate(facts);
  FlrCard card;
  card.facts = facts;
  card.functionalMl = assessment.functionalMl;
  addBody(card);
  if (assessment.divides) {
    card.functionalRemnantMl = assessment.functionalRemnantMl;
    addRatios(card);
    addThresholds(card);
  } else {
    card.reasons.emplace_back("The plan does not divide the liver, so there is no remnant to compare.");
  }
  for (const TypeBand& known : kBands) {
    if (facts.tumourType == known.type) {
      card.marginBands.push_back(known.band);
    }
  }
  return card;
}

}  // namespace glisson
