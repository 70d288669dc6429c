#pragma once

#include "solver/contact/contact_displacement.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/fragments/fragmented_body.hpp"
#include "solver/mesh/tet_mesh.hpp"
#include "solver/particles/particles.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cleave::benchmarks {

/// One scenario of the paper's Tables 1 and 2 (times on an Intel Xeon W3530 of 2010, milliseconds).
struct PaperRow {
    double stress_analysis, subdivision, crack_generation;
    double particles_before, particles_after;
    double per_added() const { return subdivision / (particles_after - particles_before); }
};

/// A scenario as it is timed here: one body of the paper, hit at one place after another, broken by what Algorithm 1 finds there.
/// Positions, forces and materials are ours (the paper gives none), the same in every run.
struct Scenario {
    std::string recipe;                       ///< the body, at the paper's count (mesh/recipes)
    std::vector<std::string> materials;       ///< of the catalogue, of regions 1, 2, ... in turn
    double force = 0;                         ///< N at each contact, along the inward normal; enough for cracks through the whole body
    int bodies = 1;                           ///< equal bodies of the scenario; one is timed
    PaperRow paper;
};

/// Seconds of the paper's three stages, over all contacts of a scenario.
struct StageSeconds {
    double stress_analysis = 0, subdivision = 0, crack_generation = 0;
};

/// A scenario's body with all that is made once.
class ScenarioBody {
public:
    explicit ScenarioBody(const Scenario& scenario);

    /// Whole again, then hit four times: at its outermost points along four directions, four groups of neighbours (Algorithm 1) each.
    /// Every crack opens the fragment that holds the tet at the contact.
    StageSeconds break_up();

    const fragments::FragmentedBody& fragments() const { return *broken_; }
    int cracks() const { return cracks_; }

private:
    struct Contact {
        contact::ContactLoad load;
        int particle;  ///< at the contact
    };
    std::vector<Contact> contacts(double force) const;

    mesh::TetMesh mesh_;
    particles::Particles particles_;
    elasticity::Solid solid_;
    elasticity::StrainOperator strain_operator_;
    std::map<int, material::Stiffness> stiffness_;  ///< by region
    std::vector<int> regions_;                      ///< of the solid's materials
    std::unique_ptr<fracture::CrackGenerator> generator_;
    std::unique_ptr<fragments::FragmentedBody> broken_;
    std::vector<Contact> contacts_;
    int cracks_ = 0;
};

/// Pot, Glass, Pots, Pet, Tai Chi by name ("pot", ...).
const std::map<std::string, Scenario>& scenarios();

}  // namespace cleave::benchmarks
