#pragma once

#include "validation/analytic/field.hpp"
#include "validation/studies/stiffness_csv.hpp"

#include <cstdint>

namespace cleave::validation {

/// A material of a sweep and the directions it is tried along.
struct SweepTensor {
    std::string name;
    std::string symmetry;           ///< one of symmetry_classes()
    material::Stiffness stiffness;  ///< Pa
    double density;                 ///< kg/m^3
    analytic::Point bar, normal;    ///< unit vectors: of a bar, of a crack
};

/// Random tensors of every class, which take turns: "random cubic 2". The first ones are the same for any number of them.
std::vector<SweepTensor> random_tensors(int count, std::uint64_t seed);

/// Every material of the catalogue, then random ones.
std::vector<SweepTensor> default_tensors(int random, std::uint64_t seed);

/// Those of a table, with a density of 2500 kg/m^3: it scales wave speeds and no error.
std::vector<SweepTensor> sweep_tensors(const std::vector<NamedStiffness>& table, std::uint64_t seed);

}  // namespace cleave::validation
