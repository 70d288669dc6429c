#include "validation/studies/sweep_tensors.hpp"

#include "solver/material/material.hpp"
#include "validation/studies/random_stiffness.hpp"
#include "validation/symmetry_class.hpp"

#include <fmt/format.h>

namespace cleave::validation {

namespace {

constexpr double usual_density = 2500;  // kg/m^3, where none is known

material::Stiffness eigen(const analytic::Stiffness& plain) {
    material::Stiffness stiffness;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) stiffness(i, j) = plain[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return stiffness;
}

void add_catalogue(std::vector<SweepTensor>& tensors) {
    for (const std::string& name : material::catalogue_names()) {
        const material::Material material = material::find_material(name);
        tensors.push_back({name, symmetry_class(material.stiffness), material.stiffness, material.density > 0 ? material.density : usual_density, {}, {}});
    }
}

void add_random(int count, std::uint64_t seed, std::vector<SweepTensor>& tensors) {
    SeededNumbers numbers(seed);
    const std::vector<std::string>& classes = symmetry_classes();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const std::string& symmetry = classes[i % classes.size()];
        const analytic::Stiffness drawn = random_stiffness(symmetry, numbers);
        tensors.push_back({fmt::format("random {} {}", symmetry, i / classes.size() + 1), symmetry, eigen(drawn), usual_density, {}, {}});
    }
}

/// From numbers of their own, so that a tensor does not depend on what it is tried along.
std::vector<SweepTensor> with_directions(std::vector<SweepTensor> tensors, std::uint64_t seed) {
    SeededNumbers numbers(~seed);
    for (SweepTensor& tensor : tensors) {
        tensor.bar = numbers.direction();
        tensor.normal = numbers.direction();
    }
    return tensors;
}

}  // namespace

std::vector<SweepTensor> random_tensors(int count, std::uint64_t seed) {
    std::vector<SweepTensor> tensors;
    add_random(count, seed, tensors);
    return with_directions(std::move(tensors), seed);
}

std::vector<SweepTensor> default_tensors(int random, std::uint64_t seed) {
    std::vector<SweepTensor> tensors;
    add_catalogue(tensors);
    add_random(random, seed, tensors);
    return with_directions(std::move(tensors), seed);
}

std::vector<SweepTensor> sweep_tensors(const std::vector<NamedStiffness>& table, std::uint64_t seed) {
    std::vector<SweepTensor> tensors;
    for (const auto& [name, stiffness] : table) tensors.push_back({name, symmetry_class(stiffness), stiffness, usual_density, {}, {}});
    return with_directions(std::move(tensors), seed);
}

}  // namespace cleave::validation
