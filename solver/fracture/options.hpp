#pragma once

#include "solver/input/table_reader.hpp"

namespace cleave::fracture {

/// What Rankine's hypothesis compares with its threshold.
enum class Criterion {
    stress,  ///< largest principal stress against the strength, Sect. 4.2
    strain   ///< largest principal strain against the strain limit: Algorithm 1, line 15 (`paper`)
};

/// How Algorithm 1, lines 10 and 11, divides the neighbours of the analysed point into groups.
enum class Grouping {
    azimuth,  ///< sectors about the contact's normal
    k_means,  ///< clusters of positions
    distance  ///< by sorted |r|, line 10 as printed (`paper`): shells, each of which averages to compression under a normal load
};

/// Where the displacement gradient of a group comes from (line 13).
enum class GroupGradient {
    neighbourhoods,  ///< of each member over its whole neighbourhood, then averaged over the group
    members          ///< Eq. 7 summed over the group's own members only, the literal text (`paper`): 50 to 100 % wrong at a surface
};

/// How Eq. 11 gives the outer radius.
enum class OuterRadius {
    proportional,  ///< r = U / (G_c B s^): proportional to the energy at fixed G_c, as Sect. 4.2 says (`paper`)
    balance        ///< G(a) = G_c of a penny crack that the group's tensile force wedges open, radii.hpp
};

/// Every choice of the crack analysis. Defaults are the well-posed readings; paper_options() has the printed ones.
struct Options {
    Criterion criterion = Criterion::stress;
    Grouping grouping = Grouping::k_means;   ///< by position, as Sect. 4.2 says; line 10 sorts by |r|
    GroupGradient group_gradient = GroupGradient::neighbourhoods;
    OuterRadius outer_radius = OuterRadius::proportional;
    int groups = 2;                  ///< N of Algorithm 1, at least 1
    double contact_area_exponent = 1;  ///< eta of s^ = (S / S_ref)^eta: 1 as printed, 0 the usual energy release rate
    double energy_limit = 0;         ///< U_limit, J/m^3, of the inner radius; 0: no inner radius
    double defined_gap = 0.2;        ///< a direction counts as defined where gap / |sigma| is at least this
    int interface_crossings = 4;     ///< materials a crack may enter one after the other; 0: cracks end at interfaces
};

/// Algorithm 1 as printed: criterion strain, grouping distance, group_gradient members. (Eq. 7 itself is the strain operator `paper`.)
Options paper_options();

/// Reads the keys of a scene's or case's table, each optional, into options that hold the defaults:
///
///   criterion = "stress" | "strain"
///   grouping = "k_means" | "azimuth" | "distance"
///   group_gradient = "neighbourhoods" | "members"
///   outer_radius = "proportional" | "balance"
///   groups = 2
///   contact_area_exponent = 1
///   energy_limit = "0 J/m^3"
///   interface_crossings = 4
///
/// Does not call finish(): other keys of the table belong to others. Throws InputError.
void read_options(TableReader& table, Options& options);

}  // namespace cleave::fracture
