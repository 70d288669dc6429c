#include "solver/mesh/vtu_file.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

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

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// How a file is written: after VTK's "VTK XML file formats", written down here a second time.
struct Style {
    bool wide = false, zlib = false, appended = false, encoded = true;
};

class VtuWriter {
public:
    VtuWriter(const TetMesh& mesh, Style style) : mesh_(mesh), style_(style) {}

    std::string text() {
        std::vector<double> points;
        std::vector<std::int64_t> connectivity, offsets;
        for (const auto& x : mesh_.vertices) points.insert(points.end(), x.begin(), x.end());
        for (const auto& tet : mesh_.tets) {
            connectivity.insert(connectivity.end(), tet.begin(), tet.end());
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        }
        const std::vector<std::uint8_t> types(mesh_.tets.size(), 10);
        const std::vector<std::int32_t> regions(mesh_.regions.begin(), mesh_.regions.end());
        std::string text = fmt::format("<?xml version='1.0'?>\n<!-- a > b -->\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"{}\"{}>\n",
                                       style_.wide ? "UInt64" : "UInt32", style_.zlib ? " compressor=\"vtkZLibDataCompressor\"" : "");
        text += fmt::format("<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh_.vertices.size(), mesh_.tets.size());
        text += "<Points>" + array("Float64", "Points", bytes_of(points)) + "</Points>\n<Cells>" + array("Int64", "connectivity", bytes_of(connectivity)) +
                array("Int64", "offsets", bytes_of(offsets)) + array("UInt8", "types", bytes_of(types)) + "</Cells>\n<CellData>" +
                array("Int32", "gmsh:physical", bytes_of(regions)) + "</CellData>\n</Piece></UnstructuredGrid>\n";
        if (style_.appended) text += fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n", style_.encoded ? "base64" : "raw", appended_);
        return text + "</VTKFile>\n";
    }

private:
    std::string header(const std::vector<std::uint64_t>& words) const {
        return style_.wide ? bytes_of(words) : bytes_of(std::vector<std::uint32_t>(words.begin(), words.end()));
    }

    std::string stored(const std::string& bytes) const {
        const auto encode = [&](const std::string& plain) { return style_.encoded ? base64(plain) : plain; };
        if (!style_.zlib) return encode(header({bytes.size()}) + bytes);
        constexpr std::size_t block = 100;  // small, so that there are several and a last one that is shorter
        std::vector<std::uint64_t> words{(bytes.size() + block - 1) / block, block, bytes.size() % block};
        std::string packed;
        for (std::size_t at = 0; at < bytes.size(); at += block) {
            const std::string piece = bytes.substr(at, block);
            uLongf size = compressBound(piece.size());
            std::string made(size, '\0');
            compress(reinterpret_cast<Bytef*>(made.data()), &size, reinterpret_cast<const Bytef*>(piece.data()), piece.size());
            packed += made.substr(0, size);
            words.push_back(size);
        }
        return encode(header(words)) + encode(packed);
    }

    std::string array(const std::string& type, const std::string& name, const std::string& bytes) {
        const std::string head = fmt::format("<DataArray type=\"{}\" Name=\"{}\" ", type, name);
        if (!style_.appended) return head + "format=\"binary\">\n " + stored(bytes) + "\n</DataArray>";
        const std::size_t offset = appended_.size();
        appended_ += stored(bytes);
        return head + fmt::format("format=\"appended\" offset=\"{}\"/>", offset);
    }

    const TetMesh& mesh_;
    Style style_;
    std::string appended_;
};

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
                const std::string bytes = VtuWriter(mesh, {wide, zlib, appended, encoded}).text();
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
            const std::string bytes = VtuWriter(test::unit_tet(), {true, zlib, true, encoded}).text();
            const std::size_t data = bytes.find("_", bytes.find("<AppendedData"));
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
