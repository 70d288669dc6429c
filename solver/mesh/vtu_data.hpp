#pragma once

#include "solver/mesh/xml_tags.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace cleave::mesh {

/// How a .vtu file stores its arrays: attributes of VTKFile and AppendedData.
struct VtuStorage {
    std::string file;                 ///< for messages
    std::size_t header_bytes = 4;     ///< of a length (header_type UInt32 or UInt64)
    bool compressed = false;          ///< zlib
    std::string_view appended;        ///< what follows the '_'; empty without
    bool appended_is_base64 = false;
};

/// The numbers of a DataArray (integers up to 2^53 are exact). Throws InputError with file and line: unknown type or format, data cut
/// short or broken, a number that is not finite.
std::vector<double> vtu_numbers(const XmlTag& array, const VtuStorage& storage);

}  // namespace cleave::mesh
