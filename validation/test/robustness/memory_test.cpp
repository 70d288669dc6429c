// The memory that a large body takes: a cube of CLEAVE_MEMORY_CELLS^3 cells in six tets each is written as a file, and cleave-simulate loads
// it, finds the stress under a ball's blow, cuts it and writes its tets. Built twice: small in every run, 4.7 million tets under the label
// memory, within 12 GB.

#include "solver/input/file_io.hpp"
#include "solver/input/test/scratch_folder.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/mesh/vtu_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

namespace cleave::robustness {
namespace {

constexpr double gigabyte = 1e9, most = 12 * gigabyte;

/// A held cube of glass, 1 m wide; a steel ball comes down on it within the first frame. Cracks reach half a metre.
std::string scene_text() {
    return R"(name = "memory"
frames = 1
frame_rate = "300 Hz"
checkpoint_every = 0
travel = "5 mm"
[[body]]
name = "cube"
mesh = "cube.msh"
material = "soda-lime glass"
strain_limit = 1e-6
groups = 4
contact_radius = "10 m"
held = [{ low = ["0 m", "0 m", "0 m"], high = ["1 m", "1 m", "0.02 m"] }]
[[body]]
name = "ball"
ball = { radius = "5 cm" }
material = "steel"
position = ["0.52 m", "0.47 m", "1.1 m"]
velocity = ["0 m/s", "0 m/s", "-20 m/s"]
[analysis]
criterion = "strain"
grouping = "azimuth"
[fracture]
scheme = "adaptive"
largest_radius = "0.5 m"
)";
}

/// How a child process ended.
struct Child {
    int exit_code = -1;
    double peak = 0;  ///< bytes, largest resident set
};

Child run_child(const std::vector<std::string>& command, const std::string& log) {
    std::fflush(nullptr);
    const pid_t pid = ::fork();
    if (pid == 0) {
        const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        ::dup2(file, 1), ::dup2(file, 2);
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    int status = 0;
    struct rusage usage {};
    if (::wait4(pid, &status, 0, &usage) != pid) return {};
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), 1024.0 * static_cast<double>(usage.ru_maxrss)};
}

/// Writes the cube without keeping it: what this process has in memory at a fork counts for nothing, but slows it.
std::size_t write_cube(const std::filesystem::path& file) {
    const mesh::TetMesh mesh = mesh::test::kuhn_cube(CLEAVE_MEMORY_CELLS, 0.15);
    mesh::write_msh(mesh, file);
    return mesh.tets.size();
}

TEST(Memory, OfACubeLoadedAnalysedCutAndWritten) {
    const ScratchFolder folder;
    const std::size_t tets = write_cube(folder / "cube.msh");
    write_file_atomic(folder / "scene.toml", scene_text());
    const Child child = run_child({CLEAVE_SIMULATE_PROGRAM, folder / "scene.toml", "--out", folder / "out"}, folder / "log");
    ASSERT_EQ(child.exit_code, 0) << read_file(folder / "log");

    const auto statistics = nlohmann::json::parse(read_file(folder / "out/statistics.json"));
    EXPECT_EQ(statistics["physical_particles"], tets);
    EXPECT_GE(statistics["fractures"], 1) << "analysed and cracked";
    const long after = statistics["subdivided_particles"];
    EXPECT_GT(after, static_cast<long>(tets)) << "cut";
    const auto written = mesh::parse_vtu(read_file(folder / "out/frames/00001.vtu"), "frame");
    EXPECT_EQ(static_cast<long>(std::get<mesh::TetMesh>(written).tets.size()), after) << "written";

    EXPECT_LE(child.peak, most);
    // Twin: the measured peak holds at least the strain operator, 24 bytes for each of some forty neighbours.
    EXPECT_GT(child.peak, 1000.0 * static_cast<double>(tets)) << "a peak that is not the child's";
    std::printf("counts: %zu tets loaded, %ld particles after the cut: peak %.2f GB, %.0f bytes per tet\n", tets, after, child.peak / gigabyte,
                child.peak / static_cast<double>(tets));
}

}  // namespace
}  // namespace cleave::robustness
