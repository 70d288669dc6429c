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
    subdivision::Subdivided result;
    result.counts = {.uncut = 3, .three_one = 1, .two_two = 0};
    result.mesh.tets.resize(17);
    result.mesh.vertices.resize(12);
    mesh::TetMesh original;
    original.vertices.resize(5);
    EXPECT_EQ(stores_like(result, original).bytes(), PureStores(14, 7).bytes());
}

}  // namespace
}  // namespace cleave::benchmarks
