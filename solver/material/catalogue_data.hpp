#pragma once

#include <string>
#include <vector>

namespace cleave::material {

/// One file of catalogue/, as it was when the program was built.
struct CatalogueFile {
    std::string name;
    std::string text;
};

/// All of them, by file name. Its definition is generated (embed.cmake).
const std::vector<CatalogueFile>& catalogue_files();

}  // namespace cleave::material
