#include "reference_fem/vtu.hpp"

#include "reference_fem/solution_data.hpp"
#include "reference_fem/vector3.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cleave::fem {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says LittleEndian");

constexpr std::size_t block_size = 1 << 20;

template <class Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// VTK's compressed array: number of blocks, size of a block, size of the last, compressed sizes, blocks.
std::string compressed(const std::string& bytes) {
    const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
    std::string header, body;
    append<std::uint64_t>(header, blocks);
    append<std::uint64_t>(header, block_size);
    append<std::uint64_t>(header, bytes.size() % block_size);
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t first = block * block_size, size = std::min(block_size, bytes.size() - first);
        uLongf length = compressBound(size);
        std::string packed(length, '\0');
        if (compress2(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(bytes.data() + first), size, 6) != Z_OK)
            throw Error("zlib could not compress the fields");
        packed.resize(length);
        append<std::uint64_t>(header, length);
        body += packed;
    }
    return header + body;
}

/// Collects the arrays of the file: their tags, and their data behind one another.
class Arrays {
public:
    template <class Number>
    void add(std::string& section, const std::string& type, const std::string& name, int components, const std::vector<Number>& values) {
        section += fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type, name,
                               components, data_.size());
        std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
        data_ += compressed(bytes);
    }
    const std::string& data() const { return data_; }

private:
    std::string data_;
};

/// VTK's order of a quadratic tet's nodes: vertices, then these edges.
constexpr std::array<std::array<int, 2>, 6> vtk_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

std::vector<int> vtk_nodes(const Discretization& space) {
    std::vector<int> nodes{0, 1, 2, 3};
    if (space.nodes_per_cell() > 4)
        for (const auto& edge : vtk_edges) nodes.push_back(space.edge_nodes(edge).back());
    return nodes;
}

struct Nodes {
    std::vector<double> positions, displacements;
    std::vector<std::int64_t> connectivity;
};

/// Nodes are numbered as cells meet them.
Nodes nodes_of(const Solution::Data& data) {
    const std::vector<int> order = vtk_nodes(data.space);
    std::vector<std::int64_t> number(data.space.dofs(), -1);  // by the dof along x
    Nodes nodes;
    for (int cell = 0; cell < static_cast<int>(data.mesh.cells.size()); ++cell)
        for (const int node : order) {
            std::int64_t& entry = number[data.space.dof(cell, node, 0)];
            if (entry < 0) {
                entry = static_cast<std::int64_t>(nodes.positions.size() / 3);
                Point x{};
                for (int i = 0; i < 4; ++i)
                    x = x + data.space.node_barycentrics()[node][i] * data.mesh.vertices[data.mesh.cells[cell][i]];
                nodes.positions.insert(nodes.positions.end(), x.begin(), x.end());
                for (int i = 0; i < 3; ++i) nodes.displacements.push_back(data.displacement[data.space.dof(cell, node, i)]);
            }
            nodes.connectivity.push_back(entry);
        }
    return nodes;
}

}  // namespace

std::string vtu_text(const Solution& solution) {
    const Solution::Data& data = solution.data();
    const Nodes nodes = nodes_of(data);
    const std::size_t cells = data.mesh.cells.size(), per_cell = nodes.connectivity.size() / cells;
    std::vector<std::int64_t> offsets;
    std::vector<double> stress, strain, error = solution.cell_errors();
    for (const FieldSample& sample : solution.quadrature_samples(1)) {
        offsets.push_back(static_cast<std::int64_t>((offsets.size() + 1) * per_cell));
        stress.insert(stress.end(), sample.stress.begin(), sample.stress.end());
        strain.insert(strain.end(), sample.strain.begin(), sample.strain.end());
        error[offsets.size() - 1] /= std::sqrt(sample.weight);
    }
    Arrays arrays;
    std::string point_data, cell_data, points, cell_section;
    arrays.add(point_data, "Float64", "displacement", 3, nodes.displacements);
    arrays.add(cell_data, "Float64", "stress", 6, stress);
    arrays.add(cell_data, "Float64", "strain", 6, strain);
    arrays.add(cell_data, "Float64", "error", 1, error);
    arrays.add(cell_data, "Int32", "region", 1, data.mesh.cell_regions);
    arrays.add(points, "Float64", "points", 3, nodes.positions);
    arrays.add(cell_section, "Int64", "connectivity", 1, nodes.connectivity);
    arrays.add(cell_section, "Int64", "offsets", 1, offsets);
    arrays.add(cell_section, "UInt8", "types", 1, std::vector<std::uint8_t>(cells, per_cell == 4 ? 10 : 24));
    return fmt::format(
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
               "compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
               "      <PointData Vectors=\"displacement\">\n{}      </PointData>\n      <CellData>\n{}      </CellData>\n      <Points>\n{}      </Points>\n"
               "      <Cells>\n{}      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_",
               nodes.positions.size() / 3, cells, point_data, cell_data, points, cell_section) +
           arrays.data() + "\n  </AppendedData>\n</VTKFile>\n";
}

}  // namespace cleave::fem
