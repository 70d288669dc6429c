#pragma once

#include "solver/contact/half_space.hpp"
#include "solver/elasticity/equilibrium.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cleave::contact {

/// Where the displacement around a contact comes from: one word in a scene.
enum class DisplacementSource {
    half_space,   ///< the paper: the body as a half-space below the contact's tangent plane, of the material at the contact
    equilibrium   ///< the body itself: free, its acceleration balancing the contact's force (inertia relief), by conforming particles
};

/// "half_space" or "equilibrium". Throws InputError that names the key.
DisplacementSource displacement_source(const std::string& word);

/// A body that can be hit. All that is referred to must outlive its use.
struct ContactBody {
    const mesh::TetMesh& mesh;                            ///< at rest; particles are its tets
    const particles::Particles& particles;
    const std::map<int, material::Stiffness>& stiffness;  ///< Pa, by region
    std::map<int, double> density{};                      ///< kg/m^3, by region; of equilibrium only, 1 where missing
};

/// Displacements (m) of the particles asked for.
using ParticleDisplacement = std::function<void(std::span<const int> particles, std::span<Eigen::Vector3d> displacement)>;

/// Stroh's sums where particles are displaced: far finer than what any strain operator leaves, at a tenth of the cost of the default.
inline constexpr HalfSpaceOptions particle_options{.accuracy = 1e-4, .most_directions = 1024};

/// Displacement of a body's particles under a contact. `half_space` evaluates where it is asked; `equilibrium` solves the whole body
/// first. half_space takes the material of the particle nearest to the contact. Throws std::invalid_argument: a region without
/// stiffness; std::runtime_error: no convergence.
ParticleDisplacement contact_displacement(DisplacementSource source, const ContactBody& body, const ContactLoad& load,
                                          const HalfSpaceOptions& options = particle_options);

/// Equilibrium of the free body under the contact. The pressure is spread over the boundary faces inside the patch and scaled so that
/// the sum is the force (a patch smaller than a face loads the nearest face).
elasticity::EquilibriumSolution contact_equilibrium(const ContactBody& body, const ContactLoad& load,
                                                    const elasticity::EquilibriumOptions& options = {});

}  // namespace cleave::contact
