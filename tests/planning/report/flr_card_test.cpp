#include "planning/report/flr_card.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reconstruction/errors.h"
#include "reconstruction/json.h"

namespace glisson {
namespace {

PlanAssessment remnantOf(double functionalRemnantMl) {
  PlanAssessment assessment;
  assessment.totalMl = 1600;
  assessment.functionalMl = 1500;
  assessment.functionalRemnantMl = functionalRemnantMl;
  return assessment;
}

std::optional<FlrRatio> ratioOf(const FlrCard& card, FlrRatioKind kind) {
  const auto found = std::find_if(card.ratios.begin(), card.ratios.end(), [&](const FlrRatio& r) { return r.kind == kind; });
  return found == card.ratios.end() ? std::nullopt : std::optional<FlrRatio>(*found);
}

std::size_t thresholdsOf(const FlrCard& card) {
  std::size_t count = 0;
  for (const FlrRatio& ratio : card.ratios) {
    count += ratio.thresholds.size();
  }
  return count;
}

/// "ratio citation value" of every threshold shown.
std::vector<std::string> shown(const FlrCard& card) {
  std::vector<std::string> lines;
  for (const FlrRatio& ratio : card.ratios) {
    for (const FlrThreshold& threshold : ratio.thresholds) {
      lines.push_back(std::string(idOf(ratio.kind)) + " " + std::string(threshold.citation) + " " + Json(threshold.value).dump());
    }
  }
  return lines;
}

bool saysWhy(const FlrCard& card, const std::string& words) {
  return std::any_of(card.reasons.begin(), card.reasons.end(),
                     [&](const std::string& reason) { return reason.find(words) != std::string::npos; });
}

const PatientFacts kNormal{170, 70, LiverCondition::Normal, std::nullopt};

TEST(FlrCard, PublishedFormulasGiveTheirTestVectors) {
  struct Vector {
    double cm, kg, bsa, urata, vauthey;
  };
  for (const Vector& v : {Vector{170, 70, 1.8181, 1286.4, 1509.7}, Vector{180, 85, 2.0616, 1458.3, 1818.2},
                          Vector{160, 55, 1.5635, 1106.5, 1186.9}}) {
    const FlrCard card = flrCard({v.cm, v.kg, LiverCondition::Normal, std::nullopt}, remnantOf(500));
    EXPECT_NEAR(card.bsaMostellerM2.value(), v.bsa, 5e-5);
    EXPECT_NEAR(card.slvUrataMl.value(), v.urata, 0.05);
    EXPECT_NEAR(card.slvVautheyMl.value(), v.vauthey, 0.05);
  }
  EXPECT_NEAR(bsaDuBoisM2(170, 70), 1.8097, 1e-4);
  // Where both formulas agree, and how far they part at the ends of the range.
  EXPECT_NEAR(slvVautheyMl(1.42) / slvUrataMl(1.42), 1, 0.005);
  EXPECT_NEAR(slvVautheyMl(1.2) / slvUrataMl(1.2), 0.85, 0.005);
  EXPECT_NEAR(slvVautheyMl(2.4) / slvUrataMl(2.4), 1.32, 0.005);
}

TEST(FlrCard, EachRatioIsTheRemnantOverItsOwnMeasure) {
  const FlrCard card = flrCard(kNormal, remnantOf(450));
  EXPECT_DOUBLE_EQ(ratioOf(card, FlrRatioKind::OfFunctionalPercent)->value, 30);
  EXPECT_NEAR(ratioOf(card, FlrRatioKind::OfSlvUrataPercent)->value, 100 * 450 / 1286.4, 0.01);
  EXPECT_NEAR(ratioOf(card, FlrRatioKind::OfSlvVautheyPercent)->value, 100 * 450 / 1509.7, 0.01);
  EXPECT_NEAR(ratioOf(card, FlrRatioKind::PerBsaMlPerM2)->value, 450 / 1.8181, 0.01);
  EXPECT_DOUBLE_EQ(ratioOf(card, FlrRatioKind::PerBodyWeightPercent)->value, 450.0 / 700);
}

TEST(FlrCard, ThresholdsStandBesideTheirOwnRatioAndForTheirOwnCondition) {
  using Lines = std::vector<std::string>;
  PatientFacts facts = kNormal;
  EXPECT_EQ(shown(flrCard(facts, remnantOf(450))),
            (Lines{"flrOfFunctionalPercent Shoup 2003 25.0", "flrOfSlvVautheyPercent Kishi 2009 20.0",
                   "flrOfSlvVautheyPercent Vauthey 2000 25.0", "flrPerBodyWeightPercent Truant 2007 0.5"}));
  facts.condition = LiverCondition::LongChemotherapy;
  EXPECT_EQ(shown(flrCard(facts, remnantOf(450))), (Lines{"flrOfSlvVautheyPercent Shindoh 2013 30.0"}));
  facts.condition = LiverCondition::Injured;
  const FlrCard injured = flrCard(facts, remnantOf(450));
  EXPECT_EQ(shown(injured), (Lines{"flrOfFunctionalPercent Azoulay 2000 40.0", "flrPerBsaMlPerM2 Shirabe 1999 250.0"}));
  EXPECT_TRUE(saysWhy(injured, "ICG R15"));
}

TEST(FlrCard, WithoutHeightWeightOrConditionNoThresholdIsShownAndSaysWhy) {
  PatientFacts facts = kNormal;
  facts.condition = std::nullopt;
  const FlrCard noCondition = flrCard(facts, remnantOf(450));
  EXPECT_EQ(thresholdsOf(noCondition), 0U);
  EXPECT_EQ(noCondition.ratios.size(), 5U);
  EXPECT_TRUE(saysWhy(noCondition, "condition is not given"));

  facts = kNormal;
  facts.heightCm = std::nullopt;
  const FlrCard noHeight = flrCard(facts, remnantOf(450));
  EXPECT_EQ(thresholdsOf(noHeight), 0U);
  EXPECT_FALSE(noHeight.slvUrataMl || noHeight.slvVautheyMl || noHeight.bsaMostellerM2 || noHeight.bsaDuBoisM2);
  EXPECT_EQ(noHeight.ratios.size(), 2U) << "of the functional volume, and of the body weight";
  EXPECT_TRUE(saysWhy(noHeight, "height is not given"));

  facts = kNormal;
  facts.weightKg = std::nullopt;
  const FlrCard noWeight = flrCard(facts, remnantOf(450));
  EXPECT_EQ(thresholdsOf(noWeight), 0U);
  EXPECT_EQ(noWeight.ratios.size(), 1U);
  EXPECT_TRUE(saysWhy(noWeight, "weight is not given"));

  const FlrCard nothing = flrCard({}, remnantOf(450));
  EXPECT_EQ(nothing.ratios.size(), 1U);
  EXPECT_EQ(nothing.reasons.size(), 3U);
}

TEST(FlrCard, OutsideTheAdultRangeThereIsNoStandardisedVolumeAndNoThreshold) {
  struct Body {
    double cm, kg;
    const char* words;
  };
  for (const Body& body : {Body{119.9, 70, "height of 119.9 cm"}, Body{220.1, 70, "height of 220.1 cm"},
                           Body{170, 29.9, "weight of 29.9 kg"}, Body{170, 250.1, "weight of 250.1 kg"},
                           Body{130, 35, "surface area of 1.12 m2"}, Body{200, 140, "surface area of 2.79 m2"}}) {
    const FlrCard card = flrCard({body.cm, body.kg, LiverCondition::Normal, std::nullopt}, remnantOf(450));
    EXPECT_FALSE(card.slvUrataMl || card.slvVautheyMl || card.bsaMostellerM2) << body.words;
    EXPECT_EQ(thresholdsOf(card), 0U) << body.words;
    EXPECT_TRUE(saysWhy(card, body.words)) << body.words;
  }
  for (const auto& [cm, kg] : {std::pair{120.0, 60.0}, std::pair{220.0, 60.0}, std::pair{190.0, 30.0}, std::pair{120.0, 190.0}}) {
    EXPECT_TRUE(flrCard({cm, kg, LiverCondition::Normal, std::nullopt}, remnantOf(450)).slvUrataMl) << cm << " " << kg;
  }
}

TEST(FlrCard, PlanThatDoesNotDivideHasNoRatio) {
  PlanAssessment assessment = remnantOf(450);
  assessment.divides = false;
  const FlrCard card = flrCard(kNormal, assessment);
  EXPECT_TRUE(card.ratios.empty());
  EXPECT_FALSE(card.functionalRemnantMl);
  EXPECT_TRUE(card.slvVautheyMl) << "the patient's, not the plan's";
  EXPECT_TRUE(saysWhy(card, "does not divide"));
}

TEST(FlrCard, NothingIsSaidAboutMarginsWithoutATumourType) {
  EXPECT_TRUE(flrCard(kNormal, remnantOf(450)).marginBands.empty());
  PatientFacts facts = kNormal;
  facts.tumourType = TumourType::ColorectalMetastases;
  const FlrCard colorectal = flrCard(facts, remnantOf(450));
  ASSERT_EQ(colorectal.marginBands.size(), 2U);
  EXPECT_EQ(colorectal.marginBands[0].mm, 1);
  EXPECT_EQ(colorectal.marginBands[1].mm, 10);
  facts.tumourType = TumourType::HepatocellularCarcinoma;
  const FlrCard hepatocellular = flrCard(facts, remnantOf(450));
  ASSERT_EQ(hepatocellular.marginBands.size(), 1U);
  EXPECT_EQ(hepatocellular.marginBands[0].mm, 5);
  EXPECT_EQ(hepatocellular.marginBands[0].citation, "Dong 2016");
}

TEST(FlrCard, FactsThatAreNoNumbersAreRefused) {
  EXPECT_THROW(flrCard({NAN, 70, std::nullopt, std::nullopt}, remnantOf(1)), PlanningError);
  EXPECT_THROW(flrCard({170, -1, std::nullopt, std::nullopt}, remnantOf(1)), PlanningError);
}

TEST(FlrCard, JsonShowsNullForWhatIsNotKnown) {
  const auto json = Json::parse(toJson(flrCard({std::nullopt, 70, std::nullopt, std::nullopt}, remnantOf(450))));
  EXPECT_TRUE(json["heightCm"].is_null());
  EXPECT_EQ(json["weightKg"], 70);
  EXPECT_TRUE(json["slvUrataMl"].is_null());
  EXPECT_EQ(json["ratios"].size(), 2U);
  EXPECT_EQ(json["ratios"][0]["thresholds"], Json::array());
  const auto full = Json::parse(toJson(flrCard(kNormal, remnantOf(450))));
  EXPECT_EQ(full["ratios"][2]["thresholds"][0], (Json{{"value", 20.0}, {"citation", "Kishi 2009"}, {"condition", "normal"}}));
}

}  // namespace
}  // namespace glisson
