#include "solver/input/table_reader.hpp"
#include "solver/simulation/scene.hpp"
#include "solver/simulation/scene_files.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

Target scene_target() {
    Target target{"scene", {}, [](const std::string& bytes) { (void)simulation::read_scene(TableReader::from_text(bytes, "input.toml")); }};
    for (const simulation::SceneFile& file : simulation::scene_files()) target.seeds.push_back(file.text);
    return target;
}

}  // namespace cleave::fuzz
