#include "validation/studies/random_stiffness.hpp"

#include "solver/material/stiffness.hpp"
#include "validation/studies/sweep_tensors.hpp"
#include "validation/symmetry_class.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cleave::validation {
namespace {

constexpr int per_class = 3;

std::vector<SweepTensor> drawn(std::uint64_t seed) { return random_tensors(per_class * static_cast<int>(symmetry_classes().size()), seed); }

// The class is found again by the planes of mirror symmetry, of which the generator knows nothing; their search stops at steps of 1e-6.
TEST(RandomStiffness, EveryClassIsWhatItSays) {
    for (const SweepTensor& tensor : drawn(1)) EXPECT_EQ(symmetry_class(tensor.stiffness, 1e-5), tensor.symmetry) << tensor.name;
}

TEST(RandomStiffness, IsStableAndWellConditioned) {
    for (const SweepTensor& tensor : drawn(2)) {
        const material::Voigt moduli = material::kelvin_moduli(tensor.stiffness);
        EXPECT_GE(moduli[0], 5e9 * (1 - 1e-12)) << tensor.name;
        EXPECT_LE(moduli[5], 200e9 * (1 + 1e-12)) << tensor.name;
    }
}

// No class by chance: the constants of a tensor have not all the same size, and no two tensors are alike.
TEST(RandomStiffness, TensorsDiffer) {
    const std::vector<SweepTensor> tensors = drawn(3);
    for (std::size_t i = 0; i < tensors.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GT((tensors[i].stiffness - tensors[j].stiffness).norm(), 1e9) << tensors[i].name << ", " << tensors[j].name;
}

TEST(RandomStiffness, TheSeedDecides) {
    const auto first = drawn(4), again = drawn(4), other = drawn(5);
    const auto fewer = random_tensors(5, 4);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].stiffness, again[i].stiffness);
        EXPECT_EQ(first[i].bar, again[i].bar);
        EXPECT_NE(first[i].stiffness, other[i].stiffness);
        EXPECT_NE(first[i].bar, other[i].bar);
        if (i < fewer.size()) {
            EXPECT_EQ(first[i].stiffness, fewer[i].stiffness) << "the first ones do not depend on how many there are";
        }
    }
}

TEST(RandomStiffness, DirectionsAreUnitVectorsOnBothSides) {
    SeededNumbers numbers(6);
    analytic::Point mean{};
    constexpr int count = 1000;
    for (int i = 0; i < count; ++i) {
        const analytic::Point p = numbers.direction();
        EXPECT_NEAR(analytic::product(p, p), 1, 1e-14);
        for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k] / count;
    }
    for (const double m : mean) EXPECT_LT(std::abs(m), 0.08) << "four standard errors, 1 / sqrt(3000) each";
}

TEST(RandomStiffness, AnUnknownClassIsRefused) {
    SeededNumbers numbers(7);
    EXPECT_THROW(random_stiffness("icosahedral", numbers), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::validation
