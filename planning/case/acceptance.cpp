#include "planning/case/acceptance.h"

#include <algorithm>
#include <array>
#include <ctime>

#include "planning/case/liver_model.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {
constexpr std::size_t kLongestName = 200;
constexpr std::string_view kTimeForm = "0000-00-00T00:00:00Z";  // 0 stands for a digit

bool isTime(std::string_view text) {
  return text.size() == kTimeForm.size() && std::equal(text.begin(), text.end(), kTimeForm.begin(), [](char c, char form) {
           return form == '0' ? c >= '0' && c <= '9' : c == form;
         });
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);  // digits only: no locale in it
  return {text.data(), length};
}
}  // namespace

Acceptance acceptedNow(std::string_view by) {
  const std::size_t first = std::min(by.find_first_not_of(' '), by.size());
  by = by.substr(first, by.find_last_not_of(' ') + 1 - first);
  Acceptance made{by.size() > kLongestName ? std::string() : std::string(by), utcNow()};
  validate(made);
  return made;
}

void validate(const Acceptance& acceptance) {
  const bool printable = std::none_of(acceptance.by.begin(), acceptance.by.end(),
                                      [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; });
  if (acceptance.by.find_first_not_of(' ') == std::string::npos || !printable) {
    throw PlanningError("Who accepts a structure needs a name of one line, at most 200 bytes long; type it again.");
  }
  if (!isTime(acceptance.at)) {
    throw PlanningError("The time at which a structure was accepted is no time; accept it again.");
  }
}

std::shared_ptr<const LiverModel> withAcceptance(const LiverModel& model, const std::vector<std::string>& ids,
                                                 const std::optional<Acceptance>& acceptance) {
  if (acceptance) {
    validate(*acceptance);
  }
  auto next = std::make_shared<LiverModel>(model);
  ++next->revision;
  for (const std::string& id : ids) {
    const auto place =
        std::find_if(next->structures.begin(), next->structures.end(), [&](const Structure& s) { return s.id == id; });
    if (place == next->structures.end()) {
      throw PlanningError("The model has no structure " + id + "; build it from the segmentation of this case.");
    }
    if (acceptance && !place->reconstruction) {
      throw PlanningError(place->name + " has no surface yet, so it cannot be accepted; reconstruct the model first.");
    }
    place->acceptance = acceptance;
  }
  return next;
}

std::vector<std::string> notAccepted(const LiverModel& model) {
  std::vector<std::string> ids;
  for (const Structure& structure : model.structures) {
    if (!structure.acceptance) {
      ids.push_back(structure.id);
    }
  }
  return ids;
}

}  // namespace glisson
