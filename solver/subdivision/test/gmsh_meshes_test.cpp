#include "solver/mesh/recipes/pot.hpp"
#include "solver/subdivision/plain_subdivision.hpp"
#include "solver/subdivision/test/sound.hpp"

#include <gtest/gtest.h>

namespace cleave::subdivision {
namespace {

using mesh::TetMesh;
using test::expect_sound;

TEST(GmshMeshes, ThePotCutBySeveralPlanes) {
    const TetMesh mesh = mesh::pot(3000).mesh;
    expect_sound(mesh, subdivide(mesh, {{.centre = {0, 0, 0.1}, .normal = {1, 0.2, 0.1}}}));
    expect_sound(mesh, subdivide(mesh, {{.centre = {0, 0, 0.1}, .normal = {1, 0.2, 0.1}},
                                        {.centre = {0, 0, 0.12}, .normal = {0.1, 0.3, 1}},
                                        {.centre = {0.1, 0, 0.1}, .normal = {0.3, 1, 0.5}, .radius = 0.05},
                                        {.centre = {0, 0, 0.05}, .normal = {1, -1, 0.2}}}));
}

}  // namespace
}  // namespace cleave::subdivision
