// The VTU file, read back by hand: deal.II's own writer of curved and quadratic tets fails (trap 5), so there is one of our own.

#include "reference_fem/vtu.hpp"

#include "reference_fem/elasticity.hpp"
#include "reference_fem/test/materials.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace cleave::fem::testing {
namespace {

Solution bent(int degree) {
    Problem problem;
    problem.mesh_file = write_box("vtu.msh", {});
    problem.regions = {{.id = 1, .stiffness = triclinic()}};
    problem.displacements = {{1, {true, true, true}, [](const Point&) { return Point{}; }}};
    problem.tractions = {{.surface = 2, .value = [](const Point&) { return Point{1e6, -2e5, 3e5}; }}};
    return solve(problem, {.degree = degree});
}

std::size_t number_after(const std::string& text, const std::string& key, std::size_t from = 0) {
    const std::size_t at = text.find(key, from);
    EXPECT_NE(at, std::string::npos) << key;
    return std::stoul(text.substr(at + key.size()));
}

template <class Number>
std::vector<Number> array(const std::string& text, const std::string& name) {
    const std::size_t offset = number_after(text, "offset=\"", text.find("Name=\"" + name + "\""));
    const std::string start = "<AppendedData encoding=\"raw\">\n_";
    const char* at = text.data() + text.find(start) + start.size() + offset;
    const auto integer = [&](std::size_t i) {
        std::uint64_t value = 0;
        std::memcpy(&value, at + 8 * i, 8);
        return value;
    };
    const std::uint64_t blocks = integer(0), size = integer(1), last = integer(2);
    const char* packed = at + 8 * (3 + blocks);
    std::string bytes;
    for (std::uint64_t block = 0; block < blocks; ++block) {
        uLongf length = block + 1 == blocks && last > 0 ? last : size;
        std::string part(length, '\0');
        EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(part.data()), &length, reinterpret_cast<const Bytef*>(packed), integer(3 + block)), Z_OK);
        EXPECT_EQ(length, part.size());
        bytes += part;
        packed += integer(3 + block);
    }
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

TEST(Vtu, HoldsTheSolution) {
    for (const int degree : {1, 2}) {
        const Solution solution = bent(degree);
        const std::string text = vtu_text(solution);
        const auto points = array<double>(text, "points"), displacement = array<double>(text, "displacement");
        const auto nodes = array<std::int64_t>(text, "connectivity");
        const auto types = array<std::uint8_t>(text, "types");
        ASSERT_EQ(points.size(), 3 * number_after(text, "NumberOfPoints=\""));
        ASSERT_EQ(types.size(), number_after(text, "NumberOfCells=\""));
        EXPECT_EQ(types[0], degree == 1 ? 10 : 24);
        EXPECT_EQ(points.size(), static_cast<std::size_t>(solution.record().dofs));
        EXPECT_EQ(array<double>(text, "stress").size(), 6 * types.size());
        for (std::size_t i = 0; i < points.size() / 3; i += 7) {
            const Point u = solution.at({points[3 * i], points[3 * i + 1], points[3 * i + 2]}).displacement;
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(displacement[3 * i + k], u[k], 1e-15);
        }
        // The nodes 4 to 9 of a quadratic tet are the midpoints of 01, 12, 02, 03, 13, 23 (VTK file formats).
        const std::size_t per_cell = nodes.size() / types.size();
        const std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
        for (std::size_t node = 4; node < per_cell; ++node)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto x = [&](std::size_t n) { return points[static_cast<std::size_t>(3 * nodes[5 * per_cell + n]) + k]; };
                EXPECT_NEAR(x(node), (x(edges[node - 4][0]) + x(edges[node - 4][1])) / 2, 1e-15) << node;
            }
        EXPECT_EQ(text, vtu_text(bent(degree)));  // the same bytes again
    }
}

}  // namespace
}  // namespace cleave::fem::testing
