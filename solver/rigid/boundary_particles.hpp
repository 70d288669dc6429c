#pragma once

#include <Eigen/Core>

#include <vector>

namespace cleave::rigid {

/// A particle at a body's surface, or the pieces of one that a fragment holds together.
struct SurfaceParticle {
    Eigen::Vector3d position;  ///< m, centre of mass
    double volume = 0;         ///< m^3
    double mass = 0;           ///< kg
    int id = 0;                ///< breaks ties
};

/// A coarse sphere for collisions in the place of a few surface particles (Sect. 5.3).
struct BoundaryParticle {
    Eigen::Vector3d position;  ///< m, the members' centre of mass (the paper's plain average moves a body's centre by up to 5e-4 of its size)
    double radius = 0;         ///< m, (3 sum V / 4 pi)^(1/3)
    double mass = 0;           ///< kg, the sum of the members' masses
    std::vector<int> members;  ///< places in the list of surface particles, the seed first
};

struct BoundaryRule {
    int group = 4;       ///< n, surface particles per boundary particle
    double reach = 1.75;  ///< members lie within this many spacings V^(1/3) of their seed
};

/// Takes the surface particles in the order of (x, y, z, id); each that is still free and has group - 1 free ones within its reach
/// takes the nearest of them (ties: the lower place). Who is left over stays alone: the paper's "unaided" particles.
/// The paper's 11,228 to 3,678 fits no grouping by four: ours falls between 2.5 and 4 to one. Empty in, empty out.
std::vector<BoundaryParticle> boundary_particles(const std::vector<SurfaceParticle>& surface, const BoundaryRule& rule = {});

}  // namespace cleave::rigid
