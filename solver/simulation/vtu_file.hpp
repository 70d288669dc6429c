#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::simulation {

/// One array of a VTU file: how ParaView calls it, and its bytes.
struct VtuArray {
    std::string name;
    std::string type;          ///< "Float32", "Int32", "UInt8"
    int components = 1;
    std::string bytes;         ///< little endian; empty where only what stands in the file is kept
    std::string compressed{};  ///< what stands in the file; filled by compress(), and then reused while the values stay
};

/// Makes an array of the values' bytes.
VtuArray float_array(const std::string& name, int components, const std::vector<float>& values);
VtuArray int_array(const std::string& name, const std::vector<std::int32_t>& values);
VtuArray byte_array(const std::string& name, const std::vector<std::uint8_t>& values);

/// Blocks of 1 MiB through zlib with VTK's headers of UInt64: count, block size, last block's size (0: full), compressed sizes. Blocks are
/// compressed in parallel; the bytes do not depend on the number of threads.
void compress(VtuArray& array);

/// The array compressed and without its bytes.
VtuArray compressed(VtuArray array);

/// Tetrahedra for ParaView.
struct VtuGrid {
    std::int64_t points = 0, cells = 0;
    VtuArray positions;                 ///< 3 components per point
    VtuArray connectivity, offsets, types;
    std::vector<VtuArray> cell_data;
};

/// The file's bytes: appended raw data, zlib, UInt64 headers. Compresses what is not compressed yet.
std::string vtu_bytes(VtuGrid& grid);

/// One step of a collection.
struct PvdEntry {
    double time = 0;   ///< s
    std::string file;  ///< relative to the collection
};
std::string pvd_text(const std::vector<PvdEntry>& entries);

}  // namespace cleave::simulation
