#include "benchmarks/subdivision_work.hpp"

#include "solver/subdivision/links.hpp"
#include "solver/subdivision/plain_subdivision.hpp"

#include <gtest/gtest.h>

namespace cleave::benchmarks {
namespace {

TEST(SubdivisionWork, ThePotIsCutSoundly) {
    const SubdivisionCase body = pot_case();
    EXPECT_NEAR(static_cast<double>(body.mesh.tets.size()), 6163, 0.02 * 6163);
    const subdivision::Subdivided result = subdivision::subdivide(body.mesh, {body.cut});
    const subdivision::Audit found = subdivision::audit(body.mesh, result);
    EXPECT_LE(found.worst_area_error, 1e-12);
    EXPECT_LE(found.volume_error, 1e-14);
    EXPECT_EQ(found.unpaired + found.asymmetric + found.paired_boundary, 0);
    EXPECT_GE(found.smallest_share, 3e-4);
    EXPECT_EQ(static_cast<int>(result.mesh.tets.size()), result.counts.uncut + 14 * result.counts.three_one + 20 * result.counts.two_two);
}

TEST(SubdivisionWork, StoresWriteTheBytesOfTheOutput) {
    EXPECT_EQ(PureStores(10, 4).bytes(), 10u * (16 + 16 + 24 + 8 + 4) + 4u * 24);
}

TEST(SubdivisionWork, TheFixedDiscCutsAsMuchInEveryCube) {
    std::vector<int> cut;
    for (const int cells : {8, 10, 14}) {
        const subdivision::Counts counts = subdivision::subdivide(cube_case(cells).mesh, {fixed_disc_in(cells)}).counts;
        cut.push_back(counts.three_one + counts.two_two);
    }
    // Vertices are shaken by their number, so the counts are alike, not equal.
    EXPECT_NEAR(cut[1], cut[0], 0.1 * cut[0]);
    EXPECT_NEAR(cut[2], cut[0], 0.1 * cut[0]);
    EXPECT_GT(cut[0], 100);
}

}  // namespace
}  // namespace cleave::benchmarks
