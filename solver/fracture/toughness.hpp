#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/stiffness.hpp"

#include <Eigen/Core>

#include <vector>

namespace cleave::fracture {

/// Critical energy release rate G_c (J/m^2) of a crack plane by its direction. With direction, the plane's angle t in [0, pi/2] from the
/// weakest plane counts, by K_c(t) / K_c(0): G_c goes with K_c^2 (the change of the modulus with direction is left out).
class Toughness {
public:
    /// The same in every direction, J/m^2 > 0.
    static Toughness uniform(double energy);

    /// One weak plane (cleavage, bedding), t the angle between the planes. Saouma et al. (1987): K_c = K0 cos^2 t + K90 sin^2 t.
    /// `energy` (J/m^2) is the weak plane's G_c; `ratio` K90/K0 > 0.
    static Toughness weak_plane(double energy, const Eigen::Vector3d& weak_normal, double ratio);

    /// Every plane along the fibre is weak, the one across it the toughest: t the angle between fibre and plane, K_c as above.
    static Toughness fibre(double energy, const Eigen::Vector3d& fibre, double ratio);

    /// The same with a measured curve instead of Saouma's: K_c(t) / K_c(0) at angles (rad) ascending from 0 to pi/2, linear in between.
    /// Throws std::invalid_argument where the angles do not, or a ratio is not positive.
    Toughness with_table(std::vector<double> angle, std::vector<double> ratio) const;

    /// G_c of a crack plane by its unit normal, J/m^2.
    double energy(const Eigen::Vector3d& crack_normal) const;

    /// K_c of that plane over the weak plane's: what the crack-tip criteria divide by. 1 where uniform.
    double intensity_ratio(const Eigen::Vector3d& crack_normal) const;

private:
    enum class Axis { none, weak_normal, fibre };

    double squared_sine(const Eigen::Vector3d& crack_normal) const;

    double energy_ = 0;
    Axis kind_ = Axis::none;
    Eigen::Vector3d axis_ = Eigen::Vector3d::UnitX();
    double ratio_ = 1;
    std::vector<double> table_angle_, table_ratio_;
};

/// What decides when and how far one material cracks.
struct Brittleness {
    double strength = 0;      ///< Pa, threshold of the criterion `stress`
    double strain_limit = 0;  ///< threshold of the criterion `strain`
    Toughness toughness = Toughness::uniform(1);
};

/// From a material's strength (Pa), toughness (J/m^2) and stiffness: strain_limit = strength / Hill's Young's modulus, uniform toughness.
Brittleness uniform_brittleness(double strength, double toughness, const material::Stiffness& stiffness);

/// The same with the keys of a table (of a scene's body or material), each optional where the given value is above zero:
///
///   strength = "40 MPa"    strain_limit = 0.002    toughness = "8 J/m^2"
///   weak_plane = { normal = [0, 1, 0], ratio = 2 }     or     fibre = { direction = [1, 0, 0], ratio = 2 }
///   weak_plane = { normal = [0, 1, 0], angle = ["0 deg", "45 deg", "90 deg"], ratio = [1, 1.3, 2] }      likewise for fibre
///
/// Does not call finish(). Throws InputError: a value missing or not positive, both forms at once, angles that do not span 0 to 90 deg.
Brittleness read_brittleness(TableReader& table, double strength, double toughness, const material::Stiffness& stiffness);

}  // namespace cleave::fracture
