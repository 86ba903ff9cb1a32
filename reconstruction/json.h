#pragma once
// Purpose: JSON as the project writes and reads it: keys keep their order. Its code is compiled once (json.cpp), since it is a
// quarter of what each file that uses it would otherwise compile.

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>

namespace glisson {

using Json = nlohmann::ordered_json;

/// x, y, z.
Json vectorJson(const Eigen::Vector3d& v);
inline Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace glisson

extern template class nlohmann::basic_json<nlohmann::ordered_map>;
extern template class nlohmann::detail::serializer<glisson::Json>;
