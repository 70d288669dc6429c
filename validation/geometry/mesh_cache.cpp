#include "validation/geometry/mesh_cache.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/msh_file.hpp"

#include <fmt/format.h>

namespace cleave::geometry {

std::filesystem::path cached_mesh(const std::filesystem::path& folder, const std::string& name, const std::string& recipe,
                                  const std::function<void()>& build, const std::function<void()>& finish) {
    const std::string identity = fmt::format("{} gmsh {}", recipe, mesh::GmshSession::version());
    const std::filesystem::path file = folder / fmt::format("{}-{}.msh", name, content_hash(identity));
    if (std::filesystem::exists(file)) return file;
    try {
        const mesh::GmshSession session;
        session.new_model(name);
        session.run(build);
        session.generate();
        if (finish) session.run(finish);
        mesh::write_msh(session.take_mesh(), file);
    } catch (const mesh::MeshingError& error) {
        throw InputError("", "geometry", fmt::format("a body that can be meshed ({}): {}", recipe, error.what()));
    }
    return file;
}

}  // namespace cleave::geometry
