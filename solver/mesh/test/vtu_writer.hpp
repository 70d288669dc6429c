#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <string>

namespace cleave::mesh::test {

/// How a .vtu file is written: after VTK's "VTK XML file formats", written down here a second time.
struct VtuStyle {
    bool wide = false;      ///< lengths of 64 bits
    bool zlib = false;
    bool appended = false;  ///< the arrays behind the XML instead of in it
    bool encoded = true;    ///< base64 (arrays in the XML always)
};

/// The tets and their regions as a .vtu whose arrays are stored in binary. Surface triangles get lost.
std::string stored_vtu(const TetMesh& mesh, const VtuStyle& style);

}  // namespace cleave::mesh::test
