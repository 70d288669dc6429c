#pragma once

#include "solver/input/table_reader.hpp"

#include <Eigen/Core>

namespace cleave::material {

/// The rotation of key "rotation": one table { axis, angle } or a list of them, applied in order, each about the fixed axes of
/// the body. Identity where the key is missing. Throws InputError (axis of length zero, unknown form).
Eigen::Matrix3d read_rotation(TableReader& reader);

}  // namespace cleave::material
