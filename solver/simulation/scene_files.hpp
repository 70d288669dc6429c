#pragma once

#include <string>
#include <vector>

namespace cleave::simulation {

/// One file of scenes/, as it was when the program was built.
struct SceneFile {
    std::string name;
    std::string text;
};

/// All of them, by file name. Its definition is generated (material/embed.cmake).
const std::vector<SceneFile>& scene_files();

}  // namespace cleave::simulation
