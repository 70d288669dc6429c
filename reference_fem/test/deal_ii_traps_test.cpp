// What deal.II 9.4.1 gets wrong on tets, and why this folder does it by other means. Should one of these tests fail on a later deal.II,
// the trap is gone and the detour may go too.

#include "reference_fem/constitutive.hpp"
#include "reference_fem/mesh.hpp"
#include "reference_fem/point_locator.hpp"
#include "reference_fem/test/msh_text.hpp"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <fstream>

namespace cleave::fem::testing {
namespace {

using Cells = dealii::Triangulation<3>;

struct Read {
    std::string path = write_box("traps.msh", {.counts = {4, 4, 4}});
    Mesh mesh = read_msh(path);
    Cells cells;
    dealii::MappingFE<3> mapping{dealii::FE_SimplexP<3>(1)};
    Read() {
        std::ifstream stream(path);
        dealii::GridIn<3>(cells).read_msh(stream);
    }
};

/// Trap 1. Centroids: as far inside a tet as can be.
TEST(DealIiTraps, FindActiveCellReturnsWrongTets) {
    const Read read;
    const PointLocator locator(read.mesh, 0);
    int wrong = 0, ours_wrong = 0;
    for (const auto& cell : read.cells.active_cell_iterators()) {
        const dealii::Point<3> centre = cell->center();
        const auto [found, unit] = dealii::GridTools::find_active_cell_around_point(read.mapping, read.cells, centre);
        wrong += found != cell;
        const auto place = locator.find({centre[0], centre[1], centre[2]});
        ours_wrong += !place || place->cell != static_cast<int>(cell->active_cell_index());
    }
    EXPECT_GT(wrong, 0);
    EXPECT_EQ(ours_wrong, 0);
}

/// Trap 2.
TEST(DealIiTraps, VolumeIsSixTimesTooLarge) {
    const Read read;
    double measured = 0;
    for (const auto& cell : read.cells.active_cell_iterators()) {
        EXPECT_NEAR(cell->measure(), signed_volume(read.mesh, static_cast<int>(cell->active_cell_index())), 1e-16);
        measured += cell->measure();
    }
    EXPECT_NEAR(measured, 1, 1e-13);
    EXPECT_NEAR(dealii::GridTools::volume(read.cells, read.mapping), 6, 1e-12);
}

/// Trap 4.
TEST(DealIiTraps, TaggedInteriorSurfaceMakesTheReaderThrow) {
    MshText text = box_mesh({.counts = {1, 1, 1}});
    text.triangles.push_back(
        {{text.tets[0].nodes[0], text.tets[0].nodes[1], text.tets[0].nodes[3]}, 70});  // along the diagonal of the brick
    std::istringstream stream(text.version_2());
    Cells cells;
    EXPECT_ANY_THROW(dealii::GridIn<3>(cells).read_msh(stream));
}

/// Trap 5: quadratic tets cannot be written; the mistake shows in debug builds only. Hence vtu.hpp, and vtu_test.cpp.
/// Trap 7: 11, 22, 33, 12, 13, 23, where ours is 11, 22, 33, 23, 13, 12: entries 3 and 5 change places.
TEST(DealIiTraps, SymmetricTensorsUnrollInAnotherOrder) {
    using Tensor2 = dealii::SymmetricTensor<2, 3>;
    EXPECT_EQ(Tensor2::unrolled_to_component_indices(3), dealii::TableIndices<2>(0, 1));
    EXPECT_EQ(Tensor2::unrolled_to_component_indices(4), dealii::TableIndices<2>(0, 2));
    EXPECT_EQ(Tensor2::unrolled_to_component_indices(5), dealii::TableIndices<2>(1, 2));
    EXPECT_EQ(voigt_index(0, 1), 5);
    EXPECT_EQ(voigt_index(1, 2), 3);
}

/// Trap 6.
TEST(DealIiTraps, InvertedTetIsTakenWithoutAWord) {
    Cells cells;
    dealii::CellData<3> tet(4);
    tet.vertices = {1, 0, 2, 3};
    cells.create_triangulation({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {tet}, {});
    EXPECT_LT(cells.begin_active()->measure(), 0);
}

}  // namespace
}  // namespace cleave::fem::testing
