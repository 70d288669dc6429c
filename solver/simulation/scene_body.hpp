#pragma once

#include "solver/contact/contact_displacement.hpp"
#include "solver/contact/contact_load.hpp"
#include "solver/elasticity/strain.hpp"
#include "solver/elasticity/strain_operator.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/fragments/fragmented_body.hpp"
#include "solver/fragments/mass_properties.hpp"
#include "solver/particles/neighbours.hpp"
#include "solver/rigid/world.hpp"
#include "solver/simulation/animation.hpp"
#include "solver/simulation/scene.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace cleave::simulation {

/// A crack as it was opened, and in which fragment: what a restart repeats.
struct OpenedCrack {
    fragments::Crack crack;
    int fragment = 0;
};

/// What the last analysis found at an original particle (zero where none came near), single precision: for pictures.
struct ParticleResult {
    std::array<float, 6> stress{};  ///< Pa, mean of the particle's group
    float energy_density = 0;       ///< J/m^3
};

/// A blow on a body, rest coordinates.
struct Blow {
    Eigen::Vector3d point;            ///< m, where it is moved to the surface from
    Eigen::Vector3d inward;           ///< unit, direction of the force
    double effective_mass = 0;        ///< kg
    double curvature = 0;             ///< 1/m, of both surfaces together
    double other_modulus = 0;         ///< Pa, indentation modulus of who hits; infinite for what does not give way
    double speed = 0;                 ///< m/s
};

/// Seconds by the clock that cracks took.
struct CrackTimes {
    double subdivision = 0;  ///< tets at the cracks, with their links
    double cracks = 0;       ///< links removed, components found
};

/// A fragment as rigid bodies and pictures need it.
struct FragmentForm {
    fragments::MassProperties mass;
    rigid::BodyDescription rigid;
    Shape shape;
    int boundary_particles = 0;
};

/// One body of a scene: its tets, kernels and materials, its cracks so far. A ball has a mass and a shape only. Rest coordinates.
class SceneBody {
public:
    /// Meshes (or takes from `cache`), shapes the kernels, builds the strain operator. Throws InputError, MeshingError.
    SceneBody(const BodySpec& spec, const Scene& scene, const std::filesystem::path& cache);
    ~SceneBody();

    const BodySpec& spec() const { return spec_; }
    bool is_ball() const { return !spec_.source; }
    /// What the strain operator had to do about poor neighbourhoods; null for what does not break.
    const elasticity::OperatorReport* operator_report() const;
    int original_particles() const { return is_ball() ? 0 : static_cast<int>(mesh_.tets.size()); }
    /// Particles now: whole ones and children.
    int particles_now() const;
    /// Fragments that have not fallen apart, ascending; {0} for a ball.
    std::vector<int> current_fragments() const;
    const fragments::FragmentedBody& fragmented() const { return *fragmented_; }
    const std::vector<OpenedCrack>& history() const { return history_; }
    const std::vector<ParticleResult>& results() const { return results_; }

    /// Mass, collision shape and picture of a fragment.
    FragmentForm form(int fragment) const;

    /// The material's indentation modulus (Pa) under a force along `inward` at the particle nearest to a place.
    double indentation_modulus(const Eigen::Vector3d& place, const Eigen::Vector3d& inward) const;

    /// The point of the body's first surface nearest to `place`, within `reach`; `place` where there is none so near.
    Eigen::Vector3d surface_point(const Eigen::Vector3d& place, double reach) const;

    /// Hertz's peak load of a blow, at the point of the surface nearest to it.
    contact::ContactLoad peak_load(const Blow& blow) const;

    /// Algorithm 1 for a load (rest coordinates). Keeps the results of the groups.
    fracture::CrackAnalysis analyse(const contact::ContactLoad& load);

    /// What cracks did to a fragment.
    struct Opened {
        std::vector<int> fragments;  ///< that it became, ascending; the same number where it stayed in one piece
        bool changed = false;        ///< tets were cut or links removed
    };
    /// Opens cracks one after the other, each in all the pieces that the ones before have left; lone particles stay whole.
    Opened open_cracks(const std::vector<fracture::Crack>& cracks, int fragment, CrackTimes& times);

    /// The region that a material of the analysis fills; none where it is the only one, or fills several.
    std::optional<int> region_of_material(int material) const;
    /// That material's name: its region's, or the body's own.
    std::string material_name(int material) const;

    /// A body made of the same spec goes through the same cracks again.
    void repeat(const std::vector<OpenedCrack>& history, std::vector<ParticleResult> results);
    /// Without its cracks.
    void make_whole();

private:
    struct Analysis;  ///< kernels, operator, generator: what only breakable bodies have
    FragmentForm ball_form() const;
    contact::ParticleDisplacement displacement_under(const contact::ContactLoad& load) const;
    void add_shape(int fragment, FragmentForm& form) const;
    bool is_held(const fragments::Fragment& fragment) const;
    const BodyMaterial& material_of_region(int region) const;
    double density_of(int original) const { return density_.at(static_cast<std::size_t>(original)); }
    void set_materials();
    void find_surface();
    Opened open_crack(const fragments::Crack& crack, int fragment, CrackTimes& times);

    BodySpec spec_;
    rigid::BoundaryRule boundary_;
    bool hulls_ = false;
    mesh::TetMesh mesh_;
    std::map<int, Eigen::Matrix3d> frames_;
    std::map<int, material::Stiffness> stiffness_;  ///< Pa, by region, body axes
    std::vector<double> density_;                   ///< kg/m^3, per original tet
    std::unique_ptr<fragments::FragmentedBody> fragmented_;
    std::vector<OpenedCrack> history_;
    std::vector<ParticleResult> results_;
    std::vector<std::array<int, 3>> surface_;       ///< the first boundary's triangles
    std::unique_ptr<particles::CellGrid> surface_grid_;  ///< of their centroids
    double surface_size_ = 0;                       ///< m, from a triangle's centroid to its farthest corner, at most
    std::unique_ptr<Analysis> analysis_;
};

/// A fragment's particles that have a face on its surface, pieces of one parent taken together.
std::vector<rigid::SurfaceParticle> surface_pieces(const fragments::FragmentedBody& body, const fragments::Fragment& fragment,
                                                   const std::vector<int>& at_surface, const std::function<double(int original)>& density);

}  // namespace cleave::simulation
