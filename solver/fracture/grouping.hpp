#pragma once

#include "solver/fracture/options.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::fracture {

/// The neighbourhood of an analysed point, seen from the point.
struct Neighbour {
    Eigen::Vector3d r;  ///< m, from the analysed point
    double volume;      ///< m^3
};

/// Frame of the analysed point.
struct PointFrame {
    Eigen::Vector3d normal;   ///< unit, into the body
    Eigen::Vector3d tangent;  ///< zero, or where the tangential load points: azimuth zero lies there
};

/// Divides the neighbours into `groups` sets by the rule (lines 10 and 11), as evenly as their number allows where the rule sorts
/// (azimuth, distance). Each set lists positions in `neighbours`, ascending. Sets may be empty where there are fewer neighbours than groups.
///
///   distance  sorted by |r|, N shells of equal count: the paper
///   azimuth   sorted by the angle about the normal, N sectors of equal count; the middle of the first is azimuth zero: the tangential
///             load, without one the direction of the neighbours' largest extent across the normal
///   k_means   Lloyd's iteration on r; seeds: the neighbour farthest from the mean, then always the one farthest from the seeds chosen
///             (Gonzalez 1985)
///
/// Depends on the places only, never on their order: equal keys are settled by the coordinates.
std::vector<std::vector<int>> divide(const std::vector<Neighbour>& neighbours, const PointFrame& frame, Grouping rule, int groups);

}  // namespace cleave::fracture
