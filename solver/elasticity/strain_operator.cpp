#include "solver/elasticity/strain_operator.hpp"

#include "solver/elasticity/operators.hpp"
#include "solver/input/input_error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cleave::elasticity {

namespace {

struct NamedOperator {
    const char* name;
    ParticleWeights weights;
};

constexpr std::array named_operators{NamedOperator{"paper", paper_weights}, NamedOperator{"corrected", corrected_weights},
                                     NamedOperator{"quadratic", quadratic_weights}};

const NamedOperator& find(const std::string& name) {
    std::string known;
    for (const NamedOperator& entry : named_operators) {
        if (name == entry.name) return entry;
        known += known.empty() ? entry.name : std::string(", ") + entry.name;
    }
    throw InputError("", "strain_operator", "one of " + known + " (not '" + name + "')");
}

}  // namespace

std::vector<std::string> strain_operator_names() {
    std::vector<std::string> names;
    for (const NamedOperator& entry : named_operators) names.emplace_back(entry.name);
    return names;
}

StrainOperator make_strain_operator(const std::string& name, const particles::Particles& particles,
                                    particles::Neighbourhood neighbourhood) {
    const NamedOperator& entry = find(name);
    StrainOperator op{name, std::move(neighbourhood.lists), {}, {particles.size(), neighbourhood.report.raised, neighbourhood.report.still_poor, 0}};
    op.weight.resize(op.neighbours.index.size());
    for (int i = 0; i < particles.size(); ++i) {
        const std::size_t first = op.neighbours.offset[i];
        const std::span<Eigen::Vector3d> weights{op.weight.data() + first, op.neighbours.offset[i + 1] - first};
        if (entry.weights(particles, i, op.neighbours.of(i), weights) == Weights::fallback) ++op.report.fallbacks;
    }
    return op;
}

Eigen::Matrix3d displacement_gradient(const StrainOperator& op, int i, const std::vector<Eigen::Vector3d>& displacement) {
    const auto neighbours = op.neighbours.of(i);
    const auto weights = op.weights_of(i);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < neighbours.size(); ++n)
        gradient += (displacement[neighbours[n]] - displacement[i]) * weights[n].transpose();
    return gradient;
}

std::vector<Eigen::Matrix3d> displacement_gradients(const StrainOperator& op, const std::vector<Eigen::Vector3d>& displacement) {
    std::vector<Eigen::Matrix3d> gradients;
    gradients.reserve(displacement.size());
    for (int i = 0; i < op.neighbours.size(); ++i) gradients.push_back(displacement_gradient(op, i, displacement));
    return gradients;
}

}  // namespace cleave::elasticity
