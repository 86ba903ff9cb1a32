#include "reconstruction/methods/methods.h"

#include <algorithm>

#include "reconstruction/errors.h"

// The list: one line for each method, the function that its file defines.
#define GLISSON_METHODS(METHOD) \
  METHOD(psrOfPlaneNormals)     \
  METHOD(mpuImplicits)          \
  METHOD(scaleAdaptiveVessels)

namespace glisson {

#define GLISSON_DECLARE(method) ReconstructionMethod method();
GLISSON_METHODS(GLISSON_DECLARE)
#undef GLISSON_DECLARE

namespace {

template <typename Named>
const Named* find(const std::vector<Named>& all, std::string_view id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.id == id; });
  return found == all.end() ? nullptr : &*found;
}

template <typename Named>
std::string idsOf(const std::vector<Named>& all) {
  std::string list;
  for (const Named& one : all) {
    list += (list.empty() ? "" : ", ") + one.id;
  }
  return list;
}

}  // namespace

const std::vector<ReconstructionMethod>& listedMethods() {
#define GLISSON_CALL(method) method(),
  static const std::vector<ReconstructionMethod> methods{GLISSON_METHODS(GLISSON_CALL)};
#undef GLISSON_CALL
  return methods;
}

const ReconstructionMethod& listedMethod(std::string_view id) {
  if (const ReconstructionMethod* found = find(listedMethods(), id)) {
    return *found;
  }
  throw UsageError("There is no reconstruction method \"" + std::string(id) + "\"; choose psr, mcsd, " + idsOf(listedMethods()) +
                   ".");
}

const MethodVariant& variantOf(const ReconstructionMethod& method, std::string_view id) {
  if (const MethodVariant* found = find(method.variants, id.empty() ? std::string_view(method.usual) : id)) {
    return *found;
  }
  throw UsageError("The method " + method.id + " has no variant \"" + std::string(id) + "\"; choose " + idsOf(method.variants) +
                   ".");
}

}  // namespace glisson
