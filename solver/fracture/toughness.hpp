#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/stiffness.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::fracture {

/// Critical energy release rate G_c (J/m^2) of a crack plane by its direction. Three forms: one value; a weak plane; a table.
class Toughness {
public:
    /// The same in every direction, J/m^2 > 0.
    static Toughness uniform(double energy);

    /// Saouma et al. (1987): K_c = K0 cos^2 + K90 sin^2 of the angle between the crack plane and the weak plane, K0 the weak plane's.
    /// `energy` (J/m^2) is the weak plane's G_c, `ratio` K90/K0 > 0; G_c goes with K_c^2, the change of the modulus with direction left
    /// out: G_c = energy (cos^2 + ratio sin^2)^2.
    static Toughness weak_plane(double energy, const Eigen::Vector3d& weak_normal, double ratio);

    /// K_c over that of the weak plane, by the angle (rad, ascending from 0 to pi/2) from the weak plane, linear in between: measured
    /// curves. Throws std::invalid_argument where the angles do not span 0 to pi/2 or a value is not positive.
    static Toughness table(double energy, const Eigen::Vector3d& weak_normal, std::vector<double> angle, std::vector<double> ratio);

    /// G_c of a crack plane by its unit normal, J/m^2.
    double energy(const Eigen::Vector3d& crack_normal) const;

    /// K_c of that plane over the least K_c tabled for the weak plane (1 where uniform): the weight of the crack-tip criteria.
    double intensity_ratio(const Eigen::Vector3d& crack_normal) const;

private:
    double energy_ = 0;
    Eigen::Vector3d weak_normal_ = Eigen::Vector3d::Zero();
    double ratio_ = 1;
    std::vector<double> table_angle_, table_ratio_;
};

/// What decides when and how far one material cracks.
struct Brittleness {
    double strength = 0;      ///< Pa, of the criterion `stress`
    double strain_limit = 0;  ///< of the criterion `strain`
    Toughness toughness = Toughness::uniform(1);
};

/// From a material's strength (Pa), toughness (J/m^2) and stiffness: strain_limit = strength / Hill's Young's modulus, uniform toughness.
Brittleness isotropic_brittleness(double strength, double toughness, const material::Stiffness& stiffness);

/// The same from a table, for scenes and cases, over values known already (each key optional):
///
///   strength = "40 MPa"     strain_limit = 0.002     toughness = "8 J/m^2"
///   weak_plane = { normal = [0, 1, 0], ratio = 2 }
///   weak_plane = { normal = [0, 1, 0], angle = ["0 deg", "45 deg", "90 deg"], ratios = [1, 1.3, 2] }
///
/// Does not call finish(). Throws InputError: values that are not positive, a table that does not span 0 to 90 deg.
Brittleness read_brittleness(TableReader& table, double strength, double toughness, const material::Stiffness& stiffness);

}  // namespace cleave::fracture
