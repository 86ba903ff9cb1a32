#include "reconstruction/json.h"

namespace glisson {
Json vectorJson(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }
}  // namespace glisson

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::serializer<glisson::Json>;
