#include "solver/material/rotation.hpp"

#include "solver/input/read_values.hpp"

#include <Eigen/Geometry>

namespace cleave::material {

namespace {

Eigen::Matrix3d read_step(TableReader& step) {
    const auto [x, y, z] = read_direction(step, "axis");
    return Eigen::AngleAxisd(step.angle("angle"), Eigen::Vector3d(x, y, z).normalized()).toRotationMatrix();
}

/// True where the value is an array: the reader has no query for a type.
bool is_list(TableReader& reader, const std::string& key) { return reader.raw(key).starts_with("["); }

}  // namespace

Eigen::Matrix3d read_rotation(TableReader& reader) {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    if (!reader.has("rotation")) return rotation;
    if (!is_list(reader, "rotation")) {
        TableReader step = reader.table("rotation");
        return read_step(step);
    }
    for (TableReader& step : reader.tables("rotation")) rotation = read_step(step) * rotation;
    return rotation;
}

}  // namespace cleave::material
