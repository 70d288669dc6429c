// cleave-fem: a case's finite element problem, spread over MPI ranks: mpirun -n 4 cleave-fem fem_le10 --size 0.1

#include "reference_fem/distributed.hpp"
#include "reference_fem/elasticity.hpp"
#include "solver/input/input_error.hpp"
#include "validation/adapters/fem_problem.hpp"
#include "validation/suite.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::validation {
namespace {

struct Arguments {
    std::string name, meshes = "out/meshes";
    std::vector<std::string> sets, serial_sets;
    double size = 0, tolerance = 1e-11;
    int degree = 2;
    bool check = false;
};

Case read_case(const Arguments& arguments, const std::vector<std::string>& sets) {
    Overrides overrides;
    for (const std::string& text : sets) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) throw InputError("", "--set", fmt::format("KEY=VALUE (not '{}')", text));
        overrides.values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    const auto files = select_files({arguments.name});
    const std::vector<Case> cases = read_cases(files.front().string(), overrides);
    if (files.size() != 1 || cases.size() != 1 || !cases.front().shape) throw InputError(arguments.name, "", "one case with a body to mesh");
    return cases.front();
}

/// Largest difference of a displacement component over the largest component.
double difference(const fem::Solution& a, const fem::Solution& b) {
    const auto left = a.vertex_displacements(), right = b.vertex_displacements();
    double most = 0, largest = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            most = std::max(most, std::abs(left[i][k] - right[i][k]));
            largest = std::max(largest, std::abs(right[i][k]));
        }
    return most / largest;
}

void print(const char* what, const fem::Solution& solution) {
    const fem::SolveRecord& record = solution.record();
    fmt::print("{:11} {} dofs, {}, {} iterations, residual {:.1e}, {:.2f} s, {:.0f} MB, energy {:.9g} J\n", what, record.dofs, record.solver, record.iterations,
               record.relative_residual, record.seconds, record.matrix_bytes / 1e6, solution.energy());
}

int run(const Arguments& arguments, const fem::MpiSession& mpi) {
    const Case of = read_case(arguments, arguments.sets);
    const double size = arguments.size > 0 ? arguments.size : of.sizes("quick").back();
    if (mpi.rank() == 0) (void)of.shape->mesh(size, arguments.meshes);  // the others find it there
    mpi.barrier();
    const fem::Problem problem = fem_problem(of, of.shape->mesh(size, arguments.meshes));
    fem::Options options;
    options.degree = arguments.degree;
    options.tolerance = arguments.tolerance;
    const fem::Solution solution = fem::solve_distributed(problem, options);
    if (mpi.rank() != 0) return 0;
    print(fmt::format("{} ranks:", mpi.size()).c_str(), solution);
    if (!arguments.check) return 0;
    std::vector<std::string> sets = arguments.sets;
    sets.insert(sets.end(), arguments.serial_sets.begin(), arguments.serial_sets.end());
    const Case alone = read_case(arguments, sets);
    const fem::Solution serial = fem::solve(fem_problem(alone, alone.shape->mesh(size, arguments.meshes)), {.degree = arguments.degree});
    print("serial:", serial);
    const double apart = difference(solution, serial);
    fmt::print("displacements differ by {:.1e} of the largest, energies by {:.1e}\n", apart, std::abs(solution.energy() / serial.energy() - 1));
    return apart <= 1e-6 ? 0 : 1;
}

int body(int argc, char** argv) {
    const fem::MpiSession mpi(argc, argv);
    CLI::App app("Solves a case's finite element problem on all MPI ranks.", "cleave-fem");
    Arguments arguments;
    app.add_option("case", arguments.name, "a shipped case's name, or a .toml file")->required();
    app.add_option("--size", arguments.size, "element size, m; default: the last of the level quick");
    app.add_option("--set", arguments.sets, "replace a value: KEY=VALUE with a dotted key")->allow_extra_args(false);
    app.add_option("--serial-set", arguments.serial_sets, "the same for the serial solve of --check only, which then has to differ")->allow_extra_args(false);
    app.add_option("--degree", arguments.degree, "1 or 2")->check(CLI::IsMember({1, 2}));
    app.add_option("--tolerance", arguments.tolerance, "relative residual at which the iteration stops");
    app.add_option("--meshes", arguments.meshes, "folder of the meshes");
    app.add_flag("--check", arguments.check, "solve serially as well; exit code 1 where displacements differ by more than 1e-6");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        if (mpi.rank() == 0) fmt::print("{}", app.help());
        return 0;
    } catch (const CLI::ParseError& error) {
        throw InputError("", "cleave-fem", fmt::format("valid options: {}", error.what()));
    }
    try {
        return run(arguments, mpi);
    } catch (const fem::Error& error) {
        throw InputError(arguments.name, "", std::string("a problem that can be solved: ") + error.what());
    }
}

}  // namespace
}  // namespace cleave::validation

int main(int argc, char** argv) { return cleave::run_program("cleave-fem", cleave::validation::body, argc, argv); }
