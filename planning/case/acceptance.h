#pragma once
// Purpose: who has looked at a structure's surface and accepts it, and when. It belongs to that one surface: made again, or made
// from another label, it is accepted by nobody.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glisson {

struct LiverModel;

struct Acceptance {
  std::string by;  ///< the person's name as typed, no patient's
  std::string at;  ///< UTC, ISO 8601: 2026-01-31T09:05:00Z
  bool operator==(const Acceptance&) const = default;
};

/// By this person, now. Blanks around the name are dropped. Throws PlanningError as validate(), and where the name is longer than
/// 200 bytes.
Acceptance acceptedNow(std::string_view by);

/// Throws PlanningError where the name is empty or holds control characters, or the time is none.
void validate(const Acceptance& acceptance);

/// A new snapshot with the acceptance of these structures replaced, or taken back where there is none; revision + 1. Throws
/// PlanningError where there is no such structure, or none of its surfaces to accept.
std::shared_ptr<const LiverModel> withAcceptance(const LiverModel& model, const std::vector<std::string>& ids,
                                                 const std::optional<Acceptance>& acceptance);

/// Ids of the structures nobody has accepted, in the model's order.
std::vector<std::string> notAccepted(const LiverModel& model);

}  // namespace glisson
