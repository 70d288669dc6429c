#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/stiffness.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace cleave::material {

/// Where a number of a material comes from. `property` is "" for a source of the whole material.
struct Source {
    std::string property;
    std::string text;
};

/// A linear elastic, brittle solid. Zero means "not given" for density, strength and toughness.
struct Material {
    std::string name;
    std::string about;
    /// The form it was given in: "isotropic", "cubic", "transversely isotropic", "orthotropic" or "general"; a rotation does not change it.
    std::string symmetry;
    Stiffness stiffness = Stiffness::Zero();  ///< Pa, in the axes of the body: after `rotation`
    double density = 0;                       ///< kg/m^3
    double strength = 0;                      ///< Pa, largest principal stress at fracture, in the weakest direction
    double toughness = 0;                     ///< J/m^2, critical energy release rate G_c, of the weakest plane
    std::vector<Source> sources;
};

/// Reads the keys of a [material] table, or of a whole material file:
///
///   name        a material of the catalogue where no stiffness is given, else a label
///   stiffness   = { voigt = [[6x6]] or [[C11, ..., C16], [C22, ...], ...] as 21 numbers, unit = "GPa" }
///   engineering = { E, nu }                                      isotropic
///               = { E1, E2, G12, nu12, and nu23 or G23 }         transversely isotropic about axis 1 (x)
///               = { E1, E2, E3, G23, G13, G12, nu12, nu13, nu23 }  orthotropic; moduli "181 GPa", ratios plain numbers
///   cubic       = { C11, C12, C44 }
///   rotation    = { axis = [0, 0, 1], angle = "30 deg" }, or a list of them, applied in order about the axes of the body
///   density "kg/m^3", strength "Pa", toughness "J/m^2", about, source (a string or several), sources = { property = "text" }
///
/// One of stiffness, engineering, cubic, or a catalogue name. Keys given beside a catalogue name replace its values.
/// Throws InputError: both or none of the forms, a stiffness that is not symmetric or not positive definite, values out of range,
/// an unknown catalogue name. Does not call reader.finish().
Material read_material(TableReader& reader);

/// A material file: the keys above at its top, or in its table [material]; unknown keys are rejected. Throws InputError.
Material read_material_file(const std::string& path);

/// Names of the built-in materials, sorted.
std::vector<std::string> catalogue_names();

/// A built-in material by name; case, blanks and punctuation do not count ("t300-5208" is "T300/5208").
/// Throws InputError that lists the names.
Material find_material(std::string_view name);

/// True where find_material would return.
bool in_catalogue(std::string_view name);

}  // namespace cleave::material
