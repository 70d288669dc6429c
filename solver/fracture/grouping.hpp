#pragma once

#include "solver/fracture/options.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::fracture {

/// One particle of the neighbourhood of an analysed point.
struct Neighbour {
    Eigen::Vector3d r;  ///< m, from the analysed point
    double volume;      ///< m^3
};

/// Frame of the analysed point.
struct PointFrame {
    Eigen::Vector3d normal;   ///< unit, into the body
    Eigen::Vector3d tangent;  ///< azimuth zero: where the tangential load points; zero without one
};

/// Divides the neighbours into N = `groups` sets (Algorithm 1, lines 10 and 11). Each set lists places in `neighbours`, ascending; sets
/// stay empty where there are fewer neighbours than groups.
///
///   distance  sorted by |r|: N shells of equal count (`paper`)
///   azimuth   sorted by the angle about the normal from -pi/N on: N sectors of equal count, azimuth zero about the middle of the first.
///             Without a tangential load azimuth zero is the direction of the neighbours' largest extent across the normal, towards the
///             side where they reach farther
///   k_means   Lloyd's iteration on r, weighted by volume. Seeds: the neighbour farthest from the mean, then always the one farthest
///             from the seeds so far (Gonzalez 1985)
///
/// Depends on the places only, not on their order: neighbours are visited, and equal keys settled, by their coordinates. Lengths and angles
/// that differ by less than 1e-9 are equal, so that rounding settles nothing.
/// Throws std::invalid_argument where groups < 1.
std::vector<std::vector<int>> divide(const std::vector<Neighbour>& neighbours, const PointFrame& frame, Grouping rule, int groups);

}  // namespace cleave::fracture
