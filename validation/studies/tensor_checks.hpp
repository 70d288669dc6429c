#pragma once

#include "validation/solve_note.hpp"
#include "validation/studies/sweep_tensors.hpp"

#include <filesystem>

namespace cleave::validation {

/// How far one method is off for one tensor, relative.
struct TensorError {
    std::string quantity, method;
    double error = 0;  ///< NaN where the method found no answer
};

/// Where the checks that solve have their meshes and sizes.
struct SweepBodies {
    std::string file;              ///< of the case, for messages
    std::filesystem::path meshes;
    double block_size = 0;         ///< m, of elements in a block of 1 m x 0.8 m x 0.6 m
    double penny_size = 0;         ///< of elements at the front, in crack radii
};

/// `patch_error`: stress of a block under the exact tractions and displacements of a linear field, largest difference over the exact stress;
/// by fem.p2, by particles in equilibrium (sph.conforming), by strain operators on given displacements (sph.corrected, sph.quadratic).
/// kelvin_as_voigt: the finite elements' stress against that of Kelvin's matrix taken for Voigt's.
std::vector<TensorError> patch_errors(const SweepTensor& tensor, const SweepBodies& bodies);

/// `bar_modulus_error`: a free bar cut along tensor.bar and pulled at its ends: its extension at every point times the exact Young's modulus
/// over the stress, less one; by fem.p2 and sph.conforming, and by the solver's formula (solver). stiffness_along: nn:C:nn for the modulus.
std::vector<TensorError> bar_errors(const SweepTensor& tensor, const SweepBodies& bodies);

/// `wave_speed_error`: the solver's wave speeds along the axes and diagonals that `cleave material --json` prints, and along tensor.bar, by the
/// coefficients of Christoffel's equation. kelvin_as_voigt: speeds in Kelvin's matrix taken for Voigt's.
std::vector<TensorError> wave_errors(const SweepTensor& tensor);

/// At the front of a penny crack across tensor.normal under pressure and shear:
/// `front_energy_release_error`: G at places of the front, from Stroh's eigenvectors (stroh) and from the particles' crack-tip fields
/// (tip_field) for the exact stress intensities, against k L^-1 k / 2 by Barnett and Lothe's integral;
/// `penny_energy_release_error`: the mean over the front (stroh) and under pressure alone (effective_modulus) against Willis's closed form.
/// modes_swapped: opening and tearing for each other.
std::vector<TensorError> front_errors(const SweepTensor& tensor);

/// `penny_energy_release_error` of a penny crack under pressure in a large block, by domain integrals of fem.p2 and of sph.conforming.
/// without_half: the finite elements against G without the energy's factor 1/2.
std::vector<TensorError> penny_errors(const SweepTensor& tensor, const SweepBodies& bodies, std::vector<SolveNote>& solves);

}  // namespace cleave::validation
