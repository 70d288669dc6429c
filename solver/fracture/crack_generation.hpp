#pragma once

#include "solver/elasticity/strain.hpp"
#include "solver/fracture/criterion.hpp"
#include "solver/fracture/grouping.hpp"
#include "solver/fracture/interfaces.hpp"
#include "solver/fracture/toughness.hpp"
#include "solver/particles/neighbours.hpp"

#include <functional>
#include <span>
#include <vector>

namespace cleave::fracture {

/// A body as Algorithm 1 sees it: at rest, in its own frame. Everything referred to must outlive its use.
struct Body {
    const particles::Particles& particles;              ///< kernels as the user shaped them
    const elasticity::StrainOperator& strain_operator;  ///< of these particles
    const elasticity::Solid& solid;
    std::vector<Brittleness> brittleness;               ///< one per material of `solid`
    std::vector<InterfaceFace> interfaces;              ///< interface_faces(); empty for one material
    double thickness = 0;                               ///< m > 0, B of Eq. 11: mean_thickness() or the user's
    double reach = 0;                                   ///< m > 0, no crack is larger: diameter() or the user's
};

/// B of Eq. 11 where the user gives none: 2 V / A of the mesh (m), the thickness of a plate or a shell.
double mean_thickness(const mesh::TetMesh& mesh);

/// Diagonal of the box around the particles, m.
double diameter(const particles::Particles& particles);

/// Where a body is hit, in its frame at rest.
struct AnalysedPoint {
    Eigen::Vector3d position;                           ///< m, on the surface
    Eigen::Vector3d normal;                             ///< unit, into the body
    Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  ///< where the tangential load points, zero without one
    double contact_area = 0;                            ///< m^2, S of Eq. 11; 0 counts as S_ref
};

/// Displacements (m) of the particles asked for, from any source. Called once per analysed point and material.
using Displacement = std::function<void(std::span<const int> particles, std::span<Eigen::Vector3d> displacement)>;

/// A field over space as a displacement of particles. `particles` must outlive the result.
Displacement displacement_from_field(const particles::Particles& particles, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> field);

/// Displacements known for every particle, as equilibrium gives them. `values` must outlive the result.
Displacement displacement_from_values(const std::vector<Eigen::Vector3d>& values);

/// One group of neighbours and what it says.
struct Group {
    std::vector<int> members;                            ///< particle ids, ascending
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();  ///< volume-weighted mean of the members' grad u
    material::Voigt strain = material::Voigt::Zero();    ///< of that mean
    material::Voigt stress = material::Voigt::Zero();    ///< Pa
    double energy = 0;                                   ///< J, SUM over the members of V_i eps_i : sigma_i / 2 (Eq. 8)
    Principal principal;                                 ///< of stress or strain
    bool defined = false;                                ///< principal.gap is at least Options::defined_gap
    bool cracked = false;                                ///< principal.value exceeds the threshold
};

/// A plane crack in a disc: what subdivision and the cutting of links take.
struct Crack {
    Eigen::Vector3d centre;    ///< m, the analysed point, or the critical point on an interface
    Eigen::Vector3d normal;    ///< unit
    double outer_radius = 0;   ///< m, of the disc
    double inner_radius = 0;   ///< m, particles within it about `centre` are isolated; 0: none
    double principal = 0;      ///< Pa or 1, what exceeded the threshold
    double gap = 0;            ///< as Principal::gap
    double energy = 0;         ///< J, of the group
    double toughness = 0;      ///< J/m^2, of this plane
    int material = 0;          ///< index in Solid: the crack cuts particles of this material only
    int group = 0;             ///< in PointAnalysis::groups
    int analysis = 0;          ///< in CrackAnalysis::points
    int parent = -1;           ///< in CrackAnalysis::cracks: the crack that reached the interface; -1 at the contact
    std::vector<int> members;  ///< particle ids of the group
};

/// Algorithm 1 at one point, for one material.
struct PointAnalysis {
    Eigen::Vector3d position;   ///< m
    int material = 0;
    int nearest = -1;           ///< particle whose kernel was taken (line 2)
    double support_radius = 0;  ///< m, of that kernel, det(G)^(-1/3)
    int considered = 0;         ///< particles inside |G r| < 1 and of the material
    int other_material = 0;     ///< particles inside, of other materials: left out
    int empty = 0;              ///< groups without members
    int below = 0;              ///< groups below the threshold
    int undefined = 0;          ///< cracked groups whose direction is undefined
    std::vector<Group> groups;
};

/// A crack that has met a material it did not come through.
struct CriticalPoint {
    Eigen::Vector3d position;  ///< m, on the interface
    int crack = 0;             ///< in CrackAnalysis::cracks
    int from = 0, to = 0;      ///< materials
    int analysis = -1;         ///< of `to` there, in CrackAnalysis::points; -1 where the crossings are used up
};

/// The whole answer: the contact's analysis first, then one for each critical point that was followed (Fig. 12).
struct CrackAnalysis {
    std::vector<Crack> cracks;
    std::vector<PointAnalysis> points;
    std::vector<CriticalPoint> critical;
};

/// Algorithm 1 for one body, with Eq. 11's radii and the passage into other materials. Holds a cell grid and scratch memory: one per body
/// and thread.
class CrackGenerator {
public:
    /// Throws std::invalid_argument: sizes that differ, a material without brittleness, thickness or reach not positive.
    explicit CrackGenerator(const Body& body);

    /// Lines 1 to 19. The material at the point is that of the nearest particle. Groups, and with them cracks, do not depend on the numbers
    /// of the particles. Throws std::invalid_argument where options.groups < 1.
    CrackAnalysis generate(const AnalysedPoint& point, const Displacement& displacement, const Options& options);

    const Body& body() const { return body_; }
    double reference_area() const { return reference_area_; }  ///< m^2, S_ref = s^2, s^3 the mean volume of a particle

private:
    static constexpr int any_material = -1;

    int nearest_particle(const Eigen::Vector3d& position, int material) const;
    PointAnalysis analyse(const AnalysedPoint& point, int material, const Displacement& displacement, const Options& options);
    std::vector<int> members_of(PointAnalysis& analysis) const;
    std::vector<Group> divide_members(const std::vector<int>& members, const AnalysedPoint& point, const Options& options) const;
    void gather_displacements(const std::vector<int>& members, const Displacement& displacement, GroupGradient rule);
    void strain_group(Group& group, GroupGradient rule) const;
    Eigen::Matrix3d whole_gradient(int particle) const;
    Eigen::Matrix3d member_gradient(int particle, const std::vector<int>& group, GroupGradient rule) const;
    void judge(Group& group, const Brittleness& brittleness, const Options& options) const;
    int analyse_into(CrackAnalysis& result, const AnalysedPoint& point, int material, int parent, const Displacement& displacement,
                     const Options& options);
    Crack crack_of(const PointAnalysis& analysis, int group, const AnalysedPoint& point, const Options& options) const;
    double outer_radius(const Crack& crack, const Group& group, const AnalysedPoint& point, const Options& options) const;
    double opening_force(const Group& group, const Crack& crack) const;

    Body body_;
    particles::CellGrid grid_;
    double reference_area_ = 0;
    double extent_ = 0;                          // m, the body's diameter
    std::vector<int> gathered_;                  // particles whose displacement has been asked for
    std::vector<int> place_;                     // of each particle in gathered_, -1 where it is not
    std::vector<Eigen::Vector3d> displacement_;  // of the gathered
    std::vector<Eigen::Vector4d> padded_;        // the same with a zero
};

}  // namespace cleave::fracture
