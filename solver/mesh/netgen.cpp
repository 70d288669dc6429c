#include "solver/mesh/netgen.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/netgen_protocol.hpp"
#include "solver/mesh/obj_file.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <vector>

namespace cleave::mesh {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes with this object, whatever happens.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (fs::temp_directory_path() / "cleave-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw EnvironmentError(fmt::format("{}: cannot be made (rights, or disk full?)", pattern));
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// The installed one beside the running program, else that of the build.
fs::path helper() {
    std::error_code unknown;
    const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
    for (const fs::path& candidate : {self.parent_path() / "cleave-netgen", fs::path(CLEAVE_NETGEN_PROGRAM)}) {
        if (fs::exists(candidate, unknown)) return candidate;
    }
    throw EnvironmentError("cleave-netgen is missing (it stands beside the other programs of an installation)");
}

/// Runs a program with its output thrown away; its wait status.
int run_silently(std::vector<std::string> arguments) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int error = ::posix_spawn(&child, argv.front(), &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw EnvironmentError(fmt::format("{}: cannot be started ({})", arguments.front(), std::generic_category().message(error)));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw EnvironmentError("cleave-netgen: its end cannot be awaited");
    }
    return status;
}

std::string reason(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU || signal == SIGKILL) return fmt::format("gave up after {} s", netgen::most_seconds);
        return fmt::format("broke down (signal {})", signal);
    }
    switch (static_cast<netgen::Stage>(WEXITSTATUS(status))) {
        case netgen::Stage::geometry: return "cannot use the surface's triangles";
        case netgen::Stage::edges: return "cannot divide the surface's edges";
        case netgen::Stage::surface: return "cannot mesh the surface";
        case netgen::Stage::volume: return "cannot mesh the inside";
        default: return fmt::format("failed (code {})", WEXITSTATUS(status));
    }
}

}  // namespace

TetMesh mesh_by_netgen(const SurfaceMesh& surface, double size, double inner_size) {
    const TemporaryFolder folder;
    const fs::path input = folder.path() / "surface.obj", output = folder.path() / "tets.msh";
    write_file_atomic(input, format_obj(surface));
    const int status = run_silently({helper().string(), input.string(), fmt::format("{:.17g}", size), fmt::format("{:.17g}", inner_size),
                                   output.string()});
    if (status != 0) throw MeshingError(fmt::format("netgen {} at size {:.4g} m", reason(status), size));
    return read_msh(output);
}

std::string netgen_version() { return CLEAVE_NETGEN_VERSION; }

}  // namespace cleave::mesh
