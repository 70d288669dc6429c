#include "solver/mesh/vtu_file.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/mesh/test/vtu_writer.hpp"

#include <gtest/gtest.h>

namespace cleave::mesh {
namespace {

std::string complaint(const std::string& bytes) {
    try {
        parse_vtu(bytes, "body.vtu");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TetMesh sample() {
    TetMesh mesh = test::kuhn_cube(2, 0.1);
    for (std::size_t i = 0; i < mesh.regions.size(); ++i) mesh.regions[i] = 1 + static_cast<int>(i % 3);
    mesh.region_names.clear();
    mesh.surface.clear();
    mesh.surface_names.clear();
    return mesh;
}

TEST(Vtu, AsciiRoundTripKeepsEverything) {
    const TetMesh mesh = sample();
    EXPECT_EQ(format_msh(std::get<TetMesh>(parse_vtu(format_vtu(mesh), "again"))), format_msh(mesh));
}

TEST(Vtu, ReadsAllWaysOfStoring) {
    const TetMesh mesh = sample();
    for (const bool wide : {false, true}) {
        for (const bool zlib : {false, true}) {
            for (const auto& [appended, encoded] : {std::pair(false, true), {true, true}, {true, false}}) {
                const std::string bytes = test::stored_vtu(mesh, {wide, zlib, appended, encoded});
                EXPECT_EQ(format_msh(std::get<TetMesh>(parse_vtu(bytes, "stored"))), format_msh(mesh)) << wide << zlib << appended << encoded;
            }
        }
    }
}

TEST(Vtu, NamesWhatIsWrong) {
    const std::string good = format_vtu(test::unit_tet());
    ASSERT_EQ(complaint(good), "");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_EQ(complaint("hello"), "body.vtu: expected a VTK XML file, which starts with <VTKFile>");
    EXPECT_EQ(complaint(with("LittleEndian", "BigEndian")), "body.vtu:2: VTKFile: expected byte_order LittleEndian");
    EXPECT_EQ(complaint(with("type=\"UnstructuredGrid\"", "type=\"PolyData\"")), "body.vtu:2: VTKFile: expected type UnstructuredGrid, not 'PolyData'");
    EXPECT_EQ(complaint(with("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")), "body.vtu: Points: expected 3 x 5 coordinates, not 12");
    EXPECT_EQ(complaint(with("0 1 2 3", "0 1 2 4")), "body.vtu: cell 1: expected points from 0 to 3, not 4");
    EXPECT_EQ(complaint(with("\n10\n", "\n12\n")), "body.vtu: cell 1: expected a linear tet (type 10) or triangle (5), not type 12");
    EXPECT_EQ(complaint(with("0 0 1\n", "0 0 nan\n")), "body.vtu:11: DataArray Points: data: expected finite numbers, not 'nan'");
    EXPECT_EQ(complaint(with("</Points>", "</Point>")), "body.vtu:17: XML: expected </Points>, not </Point>");
    EXPECT_EQ(complaint(with("\"connectivity\"", "\"connections\"")), "body.vtu: Cells: expected a DataArray connectivity");
}

TEST(Vtu, DamagedDataIsAnInputErrorWhereverItIsCut) {
    for (const bool zlib : {false, true}) {
        for (const bool encoded : {false, true}) {
            const std::string bytes = test::stored_vtu(test::unit_tet(), {true, zlib, true, encoded});
            const std::size_t data = bytes.find('_', bytes.find("<AppendedData"));
            const std::size_t end = bytes.find("\n</AppendedData>");
            for (std::size_t cut = data + 1; cut < end; cut += 7) EXPECT_NE(complaint(bytes.substr(0, cut)), "") << zlib << encoded << cut;
            std::string broken = bytes;
            broken[data + 1 + 3] = '\x7e';  // a length beyond all reason, or no base64
            broken[data + 1 + 9] = '\x7e';
            EXPECT_NE(complaint(broken), "");
        }
    }
}

}  // namespace
}  // namespace cleave::mesh
