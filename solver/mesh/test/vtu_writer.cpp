#include "solver/mesh/test/vtu_writer.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

namespace cleave::mesh::test {
namespace {

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

class VtuWriter {
public:
    VtuWriter(const TetMesh& mesh, const VtuStyle& style) : mesh_(mesh), style_(style) {}

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
    VtuStyle style_;
    std::string appended_;
};

}  // namespace

std::string stored_vtu(const TetMesh& mesh, const VtuStyle& style) { return VtuWriter(mesh, style).text(); }

}  // namespace cleave::mesh::test
