#include "validation/geometry/mesh_cache.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <unistd.h>

namespace cleave::geometry {

namespace {

class Session {
public:
    Session() {
        gmsh::initialize();
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
        gmsh::option::setNumber("Mesh.Algorithm3D", 1);
        gmsh::option::setNumber("Mesh.MshFileVersion", 2.2);
        gmsh::model::add("body");
    }
    ~Session() { gmsh::finalize(); }
};

}  // namespace

std::filesystem::path cached_mesh(const std::filesystem::path& folder, const std::string& name, const std::string& recipe,
                                  const std::function<void()>& build) {
    const std::filesystem::path file = folder / fmt::format("{}-{}.msh", name, content_hash(recipe));
    if (std::filesystem::exists(file)) return file;
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    const std::filesystem::path part = folder / fmt::format("{}-{}.{}.msh", name, content_hash(recipe), ::getpid());
    try {
        const Session session;
        build();
        gmsh::model::mesh::generate(3);
        gmsh::write(part.string());
        write_file_atomic(file, read_file(part));
        std::filesystem::remove(part, ignored);
    } catch (const std::string& message) {
        std::filesystem::remove(part, ignored);
        throw InputError("", "geometry", fmt::format("a body that Gmsh can mesh ({}): {}", recipe, message));
    }
    return file;
}

}  // namespace cleave::geometry
