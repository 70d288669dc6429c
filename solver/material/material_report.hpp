#pragma once

#include "solver/material/material.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace cleave::material {

/// What `cleave material --json` prints (schema "cleave.material/1"). Stiffness quantities are in GPa, as their keys say:
///
///   name, about, symmetry
///   youngs_modulus_GPa   along "1", "2", "3" (the axes x, y, z) and half-way between two of them: "12_45deg", "23_45deg", "13_45deg"
///   youngs_modulus_Pa    the same in Pa
///   planes_GPa           { "12": { "0deg", "45deg", "90deg" }, "23": ..., "13": ... }: Young's modulus, angle from the first axis
///   engineering          E1..E3, G23, G13, G12 (GPa), nu12, nu13, nu23: of the axes as they stand, after any rotation
///   stiffness_GPa, compliance_per_GPa   6x6, Voigt order xx, yy, zz, yz, xz, xy, engineering shear
///   eigenvalues_GPa      Kelvin's six, ascending
///   hill_youngs_modulus_GPa, universal_anisotropy
///   averages             { voigt, reuss, hill }: { bulk_GPa, shear_GPa, youngs_GPa, poisson } of the isotropic aggregate
///   extremes             { youngs_modulus_GPa, shear_modulus_GPa, poisson_ratio }: { min, max }: { value, along, across }, over all directions
///   wave_speeds_m_per_s  along "100", "010", "001", "110", "101", "011", "111" of x, y, z: [slow shear, fast shear, longitudinal];
///                        null without a density
///   density_kg_per_m3, strength_MPa, toughness_J_per_m2   null where not given
///   sources              [ { property, text } ]
nlohmann::ordered_json material_json(const Material& material);

/// The same as a table for the terminal.
std::string material_text(const Material& material);

}  // namespace cleave::material
