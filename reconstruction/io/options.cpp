#include <algorithm>

#include "reconstruction/errors.h"
#include "reconstruction/image/label_tables.h"
#include "reconstruction/io/read.h"
#include "reconstruction/text.h"

namespace glisson {

namespace {
std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string part = text.substr(from, comma - from);
    part.erase(0, std::min(part.find_first_not_of(" \t"), part.size()));
    part.erase(part.find_last_not_of(" \t") + 1);
    parts.push_back(part);
    from = comma + 1;
  }
  return parts;
}

StructureKind requireKind(const std::string& id, const std::string& assignment) {
  if (const auto kind = kindFromId(id)) {
    return *kind;
  }
  std::string known;
  for (const StructureKind kind : kAllStructureKinds) {
    known += (known.empty() ? "" : ", ") + std::string(kindId(kind));
  }
  throw UsageError("--labels " + assignment + " names no known kind of structure; the kinds are " + known + ".");
}
}  // namespace

void parseLabels(const std::string& text, ReadOptions& options) {
  for (const std::string& part : splitAtCommas(text)) {
    if (!labelTableNames(part).empty()) {
      options.labelTable = part;
      continue;
    }
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos || equals == 0) {
      throw UsageError("--labels " + part +
                       " is neither totalsegmentator, totalsegmentator-v1, totalsegmentator-mr nor NUMBER=KIND or NAME=KIND.");
    }
    const std::string name = part.substr(0, equals);
    const StructureKind kind = requireKind(part.substr(equals + 1), part);
    if (const auto label = parseInteger(name)) {
      options.kindByLabel[static_cast<int>(*label)] = kind;
    } else {
      options.kindByName[name] = kind;
    }
  }
}

void parseConsents(const std::string& text, ReadOptions& options) {
  const std::map<std::string, Consent> known{{"resample-labels", Consent::ResampleLabels},
                                             {"tilt", Consent::Tilt},
                                             {"uneven-slices", Consent::UnevenSlices},
                                             {"other-patient", Consent::OtherPatient}};
  for (const std::string& part : splitAtCommas(text)) {
    const auto found = known.find(part);
    if (found == known.end()) {
      throw UsageError("--accept " + part + " is unknown; it takes resample-labels, tilt, uneven-slices and other-patient.");
    }
    options.consents.insert(found->second);
  }
}

}  // namespace glisson
