#pragma once

#include "solver/rigid/world.hpp"
#include "solver/simulation/scene.hpp"
#include "solver/simulation/scene_body.hpp"
#include "solver/simulation/state.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cleave::simulation {

/// Seconds by the clock, for timings.json only.
struct Clock : CrackTimes {
    double dynamics = 0;     ///< rigid bodies, debris
    double analysis = 0;     ///< contact mechanics, strains, cracks' normals and radii
    double fragments = 0;    ///< new fragments: surfaces, masses, boundary particles, rigid bodies
    int fractures = 0;       ///< contacts whose cracks changed a piece
};

/// A scene on its way (Sects. 5.3 and 6): contact -> analysis -> cracks -> subdivision -> fragments -> rigid bodies. Fragments inherit
/// the velocity field of the piece they belonged to, so that linear and angular momentum stay.
class Simulation {
public:
    /// Frame 0: the bodies where the scene puts them. `meshes`: folder of stored meshes, empty for none.
    /// Throws InputError, mesh::MeshingError.
    Simulation(const Scene& scene, const std::filesystem::path& meshes);
    /// At a state that save() returned.
    Simulation(const Scene& scene, const std::filesystem::path& meshes, State state);

    /// One frame on. `stop` is asked before each substep; returns false where it said yes (the frame is then not whole and must not be shown).
    bool advance(const std::function<bool()>& stop = {});

    int frame() const { return state_.frame; }
    const Scene& scene() const { return scene_; }
    const std::vector<std::unique_ptr<SceneBody>>& bodies() const { return bodies_; }
    const std::vector<Piece>& pieces() const { return state_.pieces; }
    rigid::Motion motion(const Piece& piece) const;
    const State& state() const { return state_; }
    const Clock& clock() const { return clock_; }
    /// Grows whenever pieces come, go or change their tets.
    int topology() const { return topology_; }

    /// The state, and the world rebuilt from it: a run that goes on and one that restarts here do the same.
    State save();

private:
    /// A piece about to be analysed.
    struct Hit {
        int piece = 0;
        Eigen::Vector3d point, push;      ///< world: m; unit, direction of the force on the piece
        double impulse = 0, speed = 0;
        double effective_mass = 0;        ///< kg
        double curvature = 0;             ///< 1/m, of both surfaces
        double other_modulus = 0;         ///< Pa, indentation modulus of who hits; infinite for the ground
    };
    /// Where fragments get their velocity from: the field of the piece they were part of (its centre in rest coordinates), or each the
    /// same for its own centre where that is empty.
    using FieldCentre = std::optional<Eigen::Vector3d>;
    void add_pieces(int body, const std::vector<int>& fragments, const rigid::Motion& motion, const FieldCentre& centre);
    int substeps_of_frame() const;
    void step(double dt);
    void move_debris(double dt);
    void record_frame();
    double kinetic_energy() const;
    std::vector<double> mechanical_energies() const;
    void watch_energy(const std::vector<double>& before);
    std::vector<Hit> hits() const;
    Hit hit_of(const rigid::Contact& contact, bool first, int piece) const;
    int piece_of(int rigid) const;
    double curvature(int rigid, int sphere) const;
    double inverse_mass(int rigid, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const;
    void fracture(const Hit& hit);
    void replace(int piece, const std::vector<int>& fragments);
    void watch_momentum(const Piece& before, const rigid::Motion& before_motion, std::size_t first_new);

    Scene scene_;
    std::vector<std::unique_ptr<SceneBody>> bodies_;
    std::unique_ptr<rigid::World> world_;
    State state_;
    Clock clock_;
    int topology_ = 0;
};

}  // namespace cleave::simulation
