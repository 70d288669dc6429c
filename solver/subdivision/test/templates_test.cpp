#include "solver/subdivision/templates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>

namespace cleave::subdivision {
namespace {

std::array<PointCode, 3> face_codes(const ChildTemplate& child, int face) {
    std::array<PointCode, 3> codes{};
    for (int i = 0, count = 0; i < 4; ++i) {
        if (i != face) codes[count++] = child.points[i];
    }
    std::sort(codes.begin(), codes.end());
    return codes;
}

TEST(Templates, EdgeCodes) {
    for (int e = 0; e < 6; ++e) {
        EXPECT_EQ(edge_code(edge_ends[e][0], edge_ends[e][1]), first_edge_code + e);
        EXPECT_EQ(edge_code(edge_ends[e][1], edge_ends[e][0]), first_edge_code + e);
    }
}

TEST(Templates, ChildCountsOfAllSixteenPatterns) {
    for (unsigned mask = 0; mask < 16; ++mask) {
        const int plus = std::popcount(mask);
        const std::size_t expected = plus == 0 || plus == 4 ? 0 : plus == 2 ? 20 : 14;
        EXPECT_EQ(cut_template(mask).children.size(), expected) << mask;
        EXPECT_EQ(cut_template(mask).base_face >= 0, expected == 14) << mask;
        EXPECT_EQ(cut_template(mask).centre, expected == 20) << mask;
    }
}

TEST(Templates, PiecesMatchInsideAndCoverTheParentsFaces) {
    for (unsigned mask = 1; mask < 15; ++mask) {
        const CutTemplate& cut = cut_template(mask);
        std::map<std::array<PointCode, 3>, int> faces;
        for (const ChildTemplate& child : cut.children) {
            EXPECT_EQ(std::set<PointCode>(child.points.begin(), child.points.end()).size(), 4u);
            for (int face = 0; face < 4; ++face) ++faces[face_codes(child, face)];
        }
        std::array<int, 4> pieces{};
        for (const auto& [codes, count] : faces) {
            const unsigned common = faces_of(codes[0]) & faces_of(codes[1]) & faces_of(codes[2]);
            EXPECT_EQ(count, common == 0 ? 2 : 1) << mask;  // each inner face twice, each outer one once
            if (common != 0) ++pieces[std::countr_zero(common)];
        }
        for (int face = 0; face < 4; ++face) EXPECT_EQ(pieces[face], face == cut.base_face ? 3 : 5) << mask;
    }
}

TEST(Templates, SidesFollowTheSigns) {
    for (unsigned mask = 1; mask < 15; ++mask) {
        for (const ChildTemplate& child : cut_template(mask).children) {
            for (const PointCode code : child.points) {
                if (code >= first_edge_code) continue;
                EXPECT_EQ((mask >> code & 1U) != 0, child.side > 0) << mask;
            }
        }
    }
}

TEST(Templates, TheOppositePatternHasTheSamePiecesWithSidesSwapped) {
    for (unsigned mask = 1; mask < 15; ++mask) {
        const auto pieces = [](unsigned pattern, int turn) {
            std::set<std::pair<std::set<PointCode>, int>> found;
            for (const ChildTemplate& child : cut_template(pattern).children) {
                found.insert({{child.points.begin(), child.points.end()}, turn * child.side});
            }
            return found;
        };
        EXPECT_EQ(pieces(mask, 1), pieces(15 - mask, -1)) << mask;
    }
}

}  // namespace
}  // namespace cleave::subdivision
