#pragma once
// Purpose: what the user says about the patient for the FLR card; everything is optional, nothing is guessed from the CT.
// Units: height cm, weight kg.

#include <cstdint>
#include <optional>
#include <string_view>

namespace glisson {

enum class LiverCondition : std::uint8_t {
  Normal,
  LongChemotherapy,  ///< more than 3 months
  Injured            ///< fibrosis, cirrhosis, hepatitis
};
enum class TumourType : std::uint8_t { ColorectalMetastases, HepatocellularCarcinoma };

struct PatientFacts {
  std::optional<double> heightCm;
  std::optional<double> weightKg;
  std::optional<LiverCondition> condition;
  std::optional<TumourType> tumourType;
  bool operator==(const PatientFacts&) const = default;
};

/// "normal", "long-chemotherapy", "injured"; "colorectal-metastases", "hepatocellular": the words of files and of the command line.
std::string_view idOf(LiverCondition condition);
std::string_view idOf(TumourType type);
std::optional<LiverCondition> conditionFromId(std::string_view id);
std::optional<TumourType> tumourTypeFromId(std::string_view id);

/// Throws PlanningError where a height or weight is not a positive, finite number. A child's height is a fact too: the card says
/// what it cannot compute from it.
void validate(const PatientFacts& facts);

}  // namespace glisson
