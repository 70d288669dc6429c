#include "solver/subdivision/test/loose_tets.hpp"

#include "solver/subdivision/links.hpp"
#include "solver/subdivision/plain_subdivision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace cleave::subdivision::test {

using Eigen::Vector3d;

mesh::TetMesh loose_tets(Random& random, int count) {
    mesh::TetMesh mesh;
    for (int tet = 0; tet < count; ++tet) {
        std::array<Vector3d, 4> corners;
        for (Vector3d& corner : corners) corner = random.in_cube(-1, 1);
        if (tet % 10 == 0) corners[3] = (corners[0] + corners[1] + corners[2]) / 3 + 1e-4 * random.direction();
        double volume = mesh::signed_volume(corners[0], corners[1], corners[2], corners[3]);
        if (volume < 0) std::swap(corners[0], corners[1]), volume = -volume;
        if (volume < 1e-7) {
            --tet;
            continue;
        }
        mesh.tets.push_back({4 * tet, 4 * tet + 1, 4 * tet + 2, 4 * tet + 3});
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    }
    mesh.regions.assign(count, 1);
    return mesh;
}

long cut_loose_tets(Random& random, int batches) {
    long cut = 0;
    for (int batch = 0; batch < batches; ++batch) {
        const mesh::TetMesh mesh = loose_tets(random, 250);
        const Subdivided out = subdivide(mesh, {random.plane(-0.3, 0.3)});
        EXPECT_EQ(static_cast<int>(out.mesh.tets.size()), out.counts.after());
        EXPECT_EQ(out.counts.uncut + out.counts.three_one + out.counts.two_two, 250);
        cut += out.counts.three_one + out.counts.two_two;
        const Audit found = audit(mesh, out);
        EXPECT_LE(found.volume_error, 1e-14);
        EXPECT_LE(found.stated_volume_error, 1e-14);
        EXPECT_GT(*std::min_element(out.volume.begin(), out.volume.end()), 0);
        EXPECT_GT(found.smallest_share, 0);
        EXPECT_EQ(found.unpaired + found.asymmetric + found.paired_boundary, 0);
        EXPECT_LE(found.worst_area_error, 1e-11);  // equal faces; needle-thin triangles of slivers lose digits in their area
    }
    return cut;
}

}  // namespace cleave::subdivision::test
