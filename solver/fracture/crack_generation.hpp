#pragma once

#include "solver/elasticity/strain.hpp"
#include "solver/fracture/criterion.hpp"
#include "solver/fracture/interfaces.hpp"
#include "solver/fracture/toughness.hpp"
#include "solver/particles/neighbours.hpp"

#include <functional>
#include <span>
#include <vector>

namespace cleave::fracture {

/// A body as Algorithm 1 sees it: at rest, in its own frame. Everything referred to must outlive its use.
struct Body {
    const particles::Particles& particles;            ///< kernels as the user shaped them
    const elasticity::StrainOperator& strain_operator;  ///< of these particles
    const elasticity::Solid& solid;
    std::vector<Brittleness> brittleness;              ///< one per material of `solid`
    std::vector<InterfaceFace> interfaces;             ///< interface_faces(); empty for one material
    double thickness = 0;                              ///< m, B of Eq. 11: mean_thickness() or the user's
    double reach = 0;                                  ///< m, no crack is larger: the body's diameter
};

/// B of Eq. 11 where the user gives none: 2 V / A of the mesh, the thickness of a plate or shell, m.
double mean_thickness(const mesh::TetMesh& mesh);

/// Diagonal of the box around the particles, m.
double diameter(const particles::Particles& particles);

/// Where a body is hit, in its frame at rest.
struct AnalysedPoint {
    Eigen::Vector3d position;                                ///< m, on the surface
    Eigen::Vector3d normal;                                  ///< unit, into the body
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();       ///< direction of the tangential load, zero without one
    double contact_area = 0;                                 ///< m^2, S of Eq. 11; 0 counts as S_ref
};

/// Displacements (m) of the particles asked for: half-space solutions, equilibrium, anything. Called once per analysed point and material.
using Displacement = std::function<void(std::span<const int> particles, std::span<Eigen::Vector3d> displacement)>;

/// A field over space as a displacement of particles.
Displacement displacement_from_field(const particles::Particles& particles, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> field);

/// Displacements known for every particle, as equilibrium gives them. `values` must outlive the result.
Displacement displacement_from_values(const std::vector<Eigen::Vector3d>& values);

/// One group of neighbours and what its average says.
struct Group {
    std::vector<int> members;   ///< particle ids, ascending
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  ///< volume-weighted mean of the members' grad u
    material::Voigt strain = material::Voigt::Zero();
    material::Voigt stress = material::Voigt::Zero();    ///< Pa
    double energy = 0;          ///< J, SUM over the members of V_i eps_i : sigma_i / 2 (of the mean strain where the gradient is of members only)
    Principal principal;        ///< of the mean strain or stress
    bool defined = false;       ///< principal.gap is at least Options::defined_gap
    bool cracked = false;       ///< principal.value exceeds the threshold
};

/// A plane crack in a disc: what subdivision and link cutting take.
struct Crack {
    Eigen::Vector3d centre;     ///< m, the analysed point, or the critical point at an interface
    Eigen::Vector3d normal;     ///< unit
    double outer_radius = 0;    ///< m, of the disc
    double inner_radius = 0;    ///< m, particles within it about `centre` are isolated; 0: none
    double principal = 0;       ///< Pa or 1, what exceeded the threshold
    double gap = 0;             ///< see Principal
    double energy = 0;          ///< J, of the group
    double toughness = 0;       ///< J/m^2, of this plane
    int material = 0;           ///< index in Solid: the crack cuts particles of this material only
    int group = 0;              ///< number of the group in its analysis
    int analysis = 0;           ///< which of CrackAnalysis::points it comes from
    int parent = -1;            ///< the crack that reached the interface, in CrackAnalysis::cracks; -1 at the contact
    std::vector<int> members;   ///< particle ids of the group
};

/// Algorithm 1 at one point, for one material.
struct PointAnalysis {
    Eigen::Vector3d position;   ///< m
    int material = 0;
    int nearest = -1;           ///< particle whose kernel was taken (line 2); -1 where the body has no particle of the material nearby
    double support_radius = 0;  ///< m, of that kernel: det(G)^(-1/3)
    int considered = 0;         ///< particles inside |G r| < 1 and of the material
    int other_material = 0;     ///< particles inside, of other materials: left out
    int empty = 0;              ///< groups without members
    int below = 0;              ///< groups below the threshold
    int undefined = 0;          ///< cracks whose direction is undefined (gap below Options::defined_gap)
    std::vector<Group> groups;
};

/// A crack that has met another material.
struct CriticalPoint {
    Eigen::Vector3d position;   ///< m, on the interface, of the disc's points there the nearest to its centre
    int crack = 0;              ///< in CrackAnalysis::cracks
    int from = 0, to = 0;       ///< materials
    int analysis = -1;          ///< analysis of the other material there, in CrackAnalysis::points; -1 where the limit on crossings ended it
};

/// The whole answer: the contact's own analysis first, then one for each critical point (Fig. 12).
struct CrackAnalysis {
    std::vector<Crack> cracks;
    std::vector<PointAnalysis> points;
    std::vector<CriticalPoint> critical;
};

/// Algorithm 1 for one body, with Eq. 11's radii and the passage into other materials. Holds a cell grid and scratch memory: one per body
/// and thread.
class CrackGenerator {
public:
    /// Throws std::invalid_argument: sizes that differ, a brittleness missing.
    explicit CrackGenerator(const Body& body);

    /// Lines 1 to 19. The material at the point is that of the nearest particle. The cracks do not depend on the particles' numbers.
    /// Throws std::invalid_argument where options.groups < 1.
    CrackAnalysis generate(const AnalysedPoint& point, const Displacement& displacement, const Options& options);

    const Body& body() const { return body_; }

private:
    PointAnalysis analyse(const AnalysedPoint& point, int material, const Displacement& displacement, const Options& options);

    Body body_;
    particles::CellGrid grid_;
    double reference_area_ = 0;                 // s^2, m^2
    std::vector<int> place_;                    // of each particle in the gathered list, -1
    std::vector<int> gathered_;                 // particles whose displacement is asked for
    std::vector<Eigen::Vector3d> displacement_; // of the gathered
};

}  // namespace cleave::fracture
