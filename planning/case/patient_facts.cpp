#include "planning/case/patient_facts.h"

#include <array>
#include <cmath>
#include <utility>

#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr std::array<std::pair<LiverCondition, std::string_view>, 3> kConditions{
    {{LiverCondition::Normal, "normal"},
     {LiverCondition::LongChemotherapy, "long-chemotherapy"},
     {LiverCondition::Injured, "injured"}}};
constexpr std::array<std::pair<TumourType, std::string_view>, 2> kTumourTypes{
    {{TumourType::ColorectalMetastases, "colorectal-metastases"}, {TumourType::HepatocellularCarcinoma, "hepatocellular"}}};

template <typename Table, typename Value>
std::string_view idIn(const Table& table, Value value) {
  for (const auto& [known, id] : table) {
    if (known == value) {
      return id;
    }
  }
  return table.front().second;
}

template <typename Value, typename Table>
std::optional<Value> valueIn(const Table& table, std::string_view id) {
  for (const auto& [value, known] : table) {
    if (known == id) {
      return value;
    }
  }
  return std::nullopt;
}

bool isPositive(const std::optional<double>& value) { return !value || (std::isfinite(*value) && *value > 0); }
}  // namespace

std::string_view idOf(LiverCondition condition) { return idIn(kConditions, condition); }
std::string_view idOf(TumourType type) { return idIn(kTumourTypes, type); }
std::optional<LiverCondition> conditionFromId(std::string_view id) { return valueIn<LiverCondition>(kConditions, id); }
std::optional<TumourType> tumourTypeFromId(std::string_view id) { return valueIn<TumourType>(kTumourTypes, id); }

void validate(const PatientFacts& facts) {
  if (!isPositive(facts.heightCm) || !isPositive(facts.weightKg)) {
    throw PlanningError("The height and the weight must be positive numbers in cm and kg; type them again or leave them out.");
  }
}

}  // namespace glisson
