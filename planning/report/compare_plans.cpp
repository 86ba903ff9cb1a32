#include "planning/report/compare_plans.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planning/volumetry/margin_plane.h"
#include "reconstruction/errors.h"
#include "reconstruction/json.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
using Value = std::optional<double>;

double planesOf(const ResectionPlan& plan) {
  std::size_t planes = 0;
  for (const Resection& resection : plan.resections) {
    planes += resection.planes.size();
  }
  return static_cast<double>(planes);
}

Value ifDivides(const PlanAssessment& a, double value) { return a.divides ? Value(value) : Value(); }

double tumoursOf(const PlanAssessment& a, TumourState state) {
  return static_cast<double>(
      std::count_if(a.tumours.begin(), a.tumours.end(), [&](const TumourAssessment& t) { return !t.isCyst && t.state == state; }));
}

Value leastMarginOf(const PlanAssessment& a) {
  Value least;
  for (const TumourAssessment& tumour : a.tumours) {
    if (!tumour.isCyst && tumour.marginAtLeastMm && (!least || *tumour.marginAtLeastMm < *least)) {
      least = tumour.marginAtLeastMm;
    }
  }
  return least;
}

double wideVesselsOf(const PlanAssessment& a) {
  return static_cast<double>(std::count_if(a.vesselsCrossed.begin(), a.vesselsCrossed.end(),
                                           [](const VesselCrossing& v) { return v.diameterMm >= kListedVesselMm; }));
}

struct RowMaker {
  std::string_view id;
  Value (*value)(const AssessedPlan&);
};
constexpr auto kRows = std::to_array<RowMaker>({
    {"resections", [](const AssessedPlan& p) { return Value(static_cast<double>(p.plan.resections.size())); }},
    {"planes", [](const AssessedPlan& p) { return Value(planesOf(p.plan)); }},
    {"safetyMarginMm", [](const AssessedPlan& p) { return Value(p.plan.safetyMarginMm); }},
    {"resectedMl", [](const AssessedPlan& p) { return ifDivides(p.assessment, p.assessment.resectedMl); }},
    {"remnantMl", [](const AssessedPlan& p) { return ifDivides(p.assessment, p.assessment.remnantMl); }},
    {"functionalRemnantMl", [](const AssessedPlan& p) { return ifDivides(p.assessment, p.assessment.functionalRemnantMl); }},
    {"flrPercent", [](const AssessedPlan& p) { return ifDivides(p.assessment, p.assessment.flrPercent); }},
    {"cutAreaMm2", [](const AssessedPlan& p) { return ifDivides(p.assessment, cutAreaMm2(p.assessment)); }},
    {"tumoursRemoved", [](const AssessedPlan& p) { return Value(tumoursOf(p.assessment, TumourState::Removed)); }},
    {"tumoursCut", [](const AssessedPlan& p) { return Value(tumoursOf(p.assessment, TumourState::Cut)); }},
    {"tumoursLeft", [](const AssessedPlan& p) { return Value(tumoursOf(p.assessment, TumourState::Left)); }},
    {"leastMarginMm", [](const AssessedPlan& p) { return leastMarginOf(p.assessment); }},
    {"vesselsCrossed", [](const AssessedPlan& p) { return Value(wideVesselsOf(p.assessment)); }},
});

void mark(ComparedRow& row) {
  row.smallest.assign(row.values.size(), false);
  row.largest.assign(row.values.size(), false);
  std::vector<double> known;
  for (const Value& value : row.values) {
    if (value) {
      known.push_back(*value);
    }
  }
  if (known.size() < 2) {
    return;
  }
  const auto [least, most] = std::minmax_element(known.begin(), known.end());
  if (*least == *most) {
    return;
  }
  for (std::size_t n = 0; n < row.values.size(); ++n) {
    row.smallest[n] = row.values[n] == *least;
    row.largest[n] = row.values[n] == *most;
  }
}

/// What the differences are written into, with the plans' names at hand.
struct Difference {
  const AssessedPlan& a;
  const AssessedPlan& b;
  std::vector<std::string> sentences{};

  [[nodiscard]] const std::string& nameA() const { return a.plan.name; }
  [[nodiscard]] const std::string& nameB() const { return b.plan.name; }

  void planes() {
    const std::size_t resections = std::max(a.plan.resections.size(), b.plan.resections.size());
    for (std::size_t r = 0; r < resections; ++r) {
      if (r >= a.plan.resections.size()) {
        sentences.push_back(b.plan.resections[r].name + " is in " + nameB() + " only.");
      } else if (r >= b.plan.resections.size()) {
        sentences.push_back(a.plan.resections[r].name + " is in " + nameA() + " only.");
      } else {
        planesOfResection(a.plan.resections[r], b.plan.resections[r]);
      }
    }
  }

  void planesOfResection(const Resection& one, const Resection& other) {
    if (one.planes.size() != other.planes.size()) {
      sentences.push_back(one.name + " has " + std::to_string(one.planes.size()) + " planes in " + nameA() + " and " +
                          std::to_string(other.planes.size()) + " in " + nameB() + ".");
    }
    for (std::size_t p = 0; p < std::min(one.planes.size(), other.planes.size()); ++p) {
      const ResectionPlane& from = one.planes[p];
      const ResectionPlane& to = other.planes[p];
      const double degrees = std::atan2(from.normal.cross(to.normal).norm(), from.normal.dot(to.normal)) * 180 / std::numbers::pi;
      // A flat plane is the same wherever within it its point lies; a bend goes with the point.
      const double along = std::abs(to.normal.dot(from.origin - to.origin));
      const double away = from.bend && to.bend ? (from.origin - to.origin).norm() : along;
      const std::string turn = formatNumber(degrees, 1);
      const std::string shift = formatNumber(away, 1);
      if (turn != "0.0" || shift != "0.0") {
        sentences.push_back("Plane " + std::to_string(p + 1) + " of " + one.name + " is turned by " + turn + " degrees and lies " +
                            shift + " mm from where it was placed in " + nameA() + ".");
      }
      bendOfPlane(one.name, std::to_string(p + 1), from, to);
    }
  }

  void bendOfPlane(const std::string& resection, const std::string& number, const ResectionPlane& one,
                   const ResectionPlane& other) {
    if (one.bend.has_value() != other.bend.has_value()) {
      sentences.push_back("Plane " + number + " of " + resection + " is bent in " + (one.bend ? nameA() : nameB()) + " only.");
    } else if (one.bend != other.bend) {
      sentences.push_back("Plane " + number + " of " + resection + " is bent in another way in " + nameB() + " than in " + nameA() +
                          ".");
    }
  }

  void number(const std::string& what, const std::string& unit, const Value& one, const Value& other, int decimals) {
    const auto text = [&](const Value& value) { return value ? formatNumber(*value, decimals) + " " + unit : std::string("none"); };
    if (text(one) != text(other)) {
      sentences.push_back(what + ": " + text(one) + " in " + nameA() + ", " + text(other) + " in " + nameB() + ".");
    }
  }

  void numbers() {
    const auto row = [](const AssessedPlan& plan, std::string_view id) {
      const auto found = std::find_if(kRows.begin(), kRows.end(), [&](const RowMaker& maker) { return maker.id == id; });
      return found->value(plan);
    };
    const auto compare = [&](std::string_view id, const std::string& what, const std::string& unit, int decimals) {
      number(what, unit, row(a, id), row(b, id), decimals);
    };
    compare("safetyMarginMm", "Safety margin", "mm", 1);
    compare("resectedMl", "Resected", "mL", 1);
    compare("functionalRemnantMl", "Functional remnant", "mL", 1);
    compare("flrPercent", "FLR", "%", 1);
  }

  void tumours() {
    for (const TumourAssessment& one : a.assessment.tumours) {
      const auto other = std::find_if(b.assessment.tumours.begin(), b.assessment.tumours.end(),
                                      [&](const TumourAssessment& tumour) { return tumour.id == one.id; });
      if (other == b.assessment.tumours.end()) {
        continue;
      }
      if (one.state != other->state) {
        sentences.push_back(one.name + ": " + std::string(textOf(one.state)) + " in " + nameA() + ", " +
                            std::string(textOf(other->state)) + " in " + nameB() + ".");
      }
      number("Margin of " + one.name + ", at least", "mm", one.marginAtLeastMm, other->marginAtLeastMm, 1);
    }
  }

  void vessels() {
    number("Vessels of 3 mm and more crossed", "places", wideVesselsOf(a.assessment), wideVesselsOf(b.assessment), 0);
  }
};
}  // namespace

double cutAreaMm2(const PlanAssessment& assessment) {
  double area = 0;
  for (const ResectionVolume& resection : assessment.resections) {
    area += resection.cutAreaMm2;
  }
  return area;
}

PlanComparison comparePlans(std::span<const AssessedPlan> plans) {
  if (plans.size() < 2 || plans.size() > 4) {
    throw PlanningError("Two to four plans can be compared; choose that many.");
  }
  PlanComparison comparison;
  for (const AssessedPlan& plan : plans) {
    comparison.names.push_back(plan.plan.name);
  }
  for (const RowMaker& maker : kRows) {
    ComparedRow row{maker.id, {}, {}, {}};
    for (const AssessedPlan& plan : plans) {
      row.values.push_back(maker.value(plan));
    }
    mark(row);
    comparison.rows.push_back(std::move(row));
  }
  return comparison;
}

std::vector<std::string> differenceOf(const AssessedPlan& a, const AssessedPlan& b) {
  Difference difference{a, b};
  difference.planes();
  difference.numbers();
  difference.tumours();
  difference.vessels();
  if (difference.sentences.empty()) {
    difference.sentences.push_back(a.plan.name + " and " + b.plan.name + " are alike.");
  }
  return std::move(difference.sentences);
}

std::string toJson(const PlanComparison& comparison, const std::vector<std::string>& differences) {
  Json json;
  json["plans"] = comparison.names;
  json["rows"] = Json::array();
  for (const ComparedRow& row : comparison.rows) {
    Json values = Json::array();
    for (const Value& value : row.values) {
      values.push_back(value ? Json(*value) : Json(nullptr));
    }
    json["rows"].push_back({{"row", row.id}, {"values", values}, {"smallest", row.smallest}, {"largest", row.largest}});
  }
  json["differences"] = differences;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace glisson
