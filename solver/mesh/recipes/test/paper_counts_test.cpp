#include "solver/mesh/recipes/test/test_bodies.hpp"

#include "solver/mesh/msh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace cleave::mesh {
namespace {

/// All recipes as a scene gets them: the paper's counts (Table 1), the default mesher, twice.
class PaperCounts : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Recipe, PaperCounts, testing::ValuesIn(recipe_names()), [](const auto& info) { return info.param; });

TEST_P(PaperCounts, AreMetWithinTwoPercentTwiceToTheBit) {
    const auto info = std::find_if(recipes().begin(), recipes().end(), [&](const RecipeInfo& i) { return i.name == GetParam(); });
    const Body body = make_body(test::recipe(GetParam(), 0));
    test::expect_sound(body, info->particles);
    EXPECT_EQ(body.mesh.region_names.size(), info->regions.size());
    EXPECT_LE(body.record.slivers, body.record.count / 1000);
    EXPECT_EQ(format_msh(make_body(test::recipe(GetParam(), 0)).mesh), format_msh(body.mesh));
    RecordProperty("tets", body.record.count);
    RecordProperty("smallest_dihedral_deg", std::to_string(body.record.smallest_dihedral * 180 / std::numbers::pi));
}

}  // namespace
}  // namespace cleave::mesh
