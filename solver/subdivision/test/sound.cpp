#include "solver/subdivision/test/sound.hpp"

#include "solver/mesh/check.hpp"
#include "solver/subdivision/links.hpp"

#include <gtest/gtest.h>

namespace cleave::subdivision::test {

void expect_sound(const mesh::TetMesh& mesh, const Subdivided& out) {
    EXPECT_EQ(static_cast<int>(out.mesh.tets.size()), out.counts.after());
    const Audit found = audit(mesh, out);
    EXPECT_LE(found.worst_area_error, 1e-12);
    EXPECT_LE(found.volume_error, 1e-14);
    EXPECT_LE(found.stated_volume_error, 1e-14);
    EXPECT_EQ(found.asymmetric, 0);
    EXPECT_EQ(found.unpaired, 0);
    EXPECT_EQ(found.paired_boundary, 0);
    EXPECT_GE(found.smallest_share, 1e-4);  // tau = 0.1 (3e-4 on meshes of ordinary shape)
    mesh::check(out.mesh, "subdivided");
}

}  // namespace cleave::subdivision::test
