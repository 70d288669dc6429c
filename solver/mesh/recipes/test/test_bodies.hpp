#pragma once

#include "solver/mesh/check.hpp"
#include "solver/mesh/recipes/recipes.hpp"
#include "solver/mesh/tet_mesh.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace cleave::mesh::test {

inline BodySource recipe(const std::string& name, int particles) {
    BodySource source;
    source.recipe = name;
    source.particles = particles;
    return source;
}

/// Volume of each region, m^3.
inline std::map<int, double> region_volumes(const TetMesh& mesh) {
    std::map<int, double> volumes;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) volumes[mesh.regions[tet]] += tet_volume(mesh, static_cast<int>(tet));
    return volumes;
}

/// Sound, marked all around, and within 2 % of its count.
inline void expect_sound(const Body& body, int target) {
    check(body.mesh, "body");
    EXPECT_NEAR(body.record.count, target, 0.02 * target);
    std::size_t boundary = 0;
    for (const int other : link_half_faces(body.mesh).opposite) boundary += other < 0;
    EXPECT_EQ(boundary, body.mesh.surface.size());
    EXPECT_EQ(body.mesh.surface_names, (std::map<int, std::string>{{1, "outside"}}));
}

}  // namespace cleave::mesh::test
