#include "solver/mesh/size_tuning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cleave::mesh {
namespace {

TetMesh mesh_of(double count) {
    TetMesh mesh;
    mesh.tets.resize(static_cast<std::size_t>(count));
    return mesh;
}

TEST(SizeTuning, ReachesTheTargetForSurfaceAndSolidScaling) {
    for (const double exponent : {2.0, 2.5, 3.0}) {
        for (const double first : {0.05, 0.1, 0.4}) {
            const TunedMesh tuned = tune_count([&](double h) { return mesh_of(7 * std::pow(h, -exponent)); }, first, 6163);
            EXPECT_NEAR(static_cast<double>(tuned.mesh.tets.size()), 6163, 0.005 * 6163) << exponent << " from " << first;
            EXPECT_LE(tuned.rounds, 7);
            EXPECT_NEAR(7 * std::pow(tuned.size, -exponent), static_cast<double>(tuned.mesh.tets.size()), 1);
        }
    }
}

TEST(SizeTuning, KeepsTheNearestWhereCountsJump) {
    // A mesher that can only give 5000 or 6000: the search must stay with 6000 and end.
    int calls = 0;
    const TunedMesh tuned = tune_count([&](double h) { return ++calls, mesh_of(h > 0.17 ? 5000 : 6000); }, 0.2, 6163);
    EXPECT_EQ(tuned.mesh.tets.size(), 6000u);
    EXPECT_EQ(tuned.rounds, calls);
    EXPECT_LE(calls, 10);
    EXPECT_GT(tuned.size_of_too_few, 0);  // all had too few
}

TEST(SizeTuning, TriesLongerWhereCountsAreNoisy) {
    // Counts that go up and down by 5 % from size to size, as NETGEN's do: seven rounds would not do from here.
    const auto noisy = [](double h) { return 7 * std::pow(h, -2.5) * (1 + 0.05 * std::sin(4000 * h)); };
    const TunedMesh tuned = tune_count([&](double h) { return mesh_of(noisy(h)); }, 0.4, 6163);
    EXPECT_NEAR(static_cast<double>(tuned.mesh.tets.size()), 6163, 0.02 * 6163);
    EXPECT_LE(tuned.rounds, 10);
}

TEST(SizeTuning, RefusesNonsense) {
    EXPECT_THROW(tune_count([](double) { return mesh_of(1); }, 0.1, 0), std::invalid_argument);
    EXPECT_THROW(tune_count([](double) { return mesh_of(1); }, 0, 10), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::mesh
