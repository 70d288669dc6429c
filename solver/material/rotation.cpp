#include "solver/material/rotation.hpp"

#include "solver/input/input_error.hpp"

#include <Eigen/Geometry>

namespace cleave::material {

namespace {

Eigen::Matrix3d read_step(TableReader& step) {
    const std::vector<double> axis = step.numbers("axis");
    const Eigen::Vector3d direction = axis.size() == 3 ? Eigen::Vector3d(axis[0], axis[1], axis[2]) : Eigen::Vector3d::Zero();
    if (!(direction.norm() > 0)) step.fail("axis", "three numbers, not all zero");
    return Eigen::AngleAxisd(step.angle("angle"), direction.normalized()).toRotationMatrix();
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
