// Inputs tried without a fuzzer: those that fuzzers have found, once more, and damaged seeds.
//
//   fuzz_regression FOLDER                    FOLDER/TARGET/FILE must be refused in one line, names that start with fine_ accepted, the seeds too
//   fuzz_regression --mutate COUNT FINDS [SEED [TARGET]]
//                                             COUNT damaged seeds for each target; those that survive go to the folder FINDS
//   fuzz_regression --twin FINDS              plants faults and demands that each is reported

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "validation/test/fuzz/answer.hpp"
#include "validation/test/fuzz/mutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace {

using namespace cleave;
using fuzz::Answer;
using fuzz::Target;
using fuzz::Tried;
namespace fs = std::filesystem;

std::vector<Target> all_targets() {
    using namespace fuzz;
    return {material_target(), scene_target(), case_target(), msh_target(), medit_target(), vtu_target(), stl_target(), obj_target(),
            fem_msh_target(), checkpoint_target(), results_target(), stored_case_target(), report_target(), samples_target(), table_target()};
}

void print_counts(const std::string& name, const Tried& tried) {
    fmt::print("{:<12} {:>9} inputs tried, {:>9} accepted, {:>9} refused, {} survivors\n", name, tried.all(), tried.accepted, tried.refused, tried.survivors);
    std::fflush(stdout);
}

Tried operator+(const Tried& a, const Tried& b) { return {a.accepted + b.accepted, a.refused + b.refused, a.survivors + b.survivors}; }

/// An answer other than the wanted one counts as a survivor.
void add(Tried& tried, Answer got, Answer wanted, const std::string& name) {
    if (got == wanted) {
        ++(got == Answer::accepted ? tried.accepted : tried.refused);
        return;
    }
    ++tried.survivors;
    fmt::print(stderr, "{}: expected to be {}\n", name, wanted == Answer::accepted ? "accepted" : "refused");
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

Tried try_kept(const Target& target, const fs::path& folder) {
    Tried tried;
    for (std::size_t i = 0; i < target.seeds.size(); ++i)
        add(tried, answer(target, target.seeds[i]), Answer::accepted, fmt::format("{}, seed {}", target.name, i + 1));
    for (const fs::path& file : files_in(folder))
        add(tried, answer(target, read_file(file)), file.filename().string().starts_with("fine_") ? Answer::accepted : Answer::refused, file.string());
    return tried;
}

int run_kept(const fs::path& folder) {
    Tried sum;
    std::size_t folders = 0;
    for (const Target& target : all_targets()) {
        const Tried tried = try_kept(target, folder / target.name);
        print_counts(target.name, tried);
        sum = sum + tried;
        folders += fs::is_directory(folder / target.name) ? 1 : 0;
    }
    print_counts("counts: kept inputs and seeds", sum);
    if (folders != files_in(folder).size()) throw InputError(folder.string(), "", "one folder per target and nothing else");
    return sum.survivors == 0 && sum.refused > 0 ? 0 : 1;
}

int run_mutations(long count, const fs::path& finds, std::uint64_t seed, const std::string& only) {
    Tried sum;
    for (const Target& target : all_targets()) {
        if (!only.empty() && target.name != only) continue;
        const Tried tried = try_mutations(target, count, seed, finds);
        print_counts(target.name, tried);
        sum = sum + tried;
    }
    print_counts("counts: damaged seeds", sum);
    return sum.survivors == 0 && sum.all() > 0 ? 0 : 1;
}

/// Each planted fault must be taken for a survivor; the answers that are none for what they are; damaged seeds must meet one as well.
int run_twin(const fs::path& finds) {
    const Target twin = fuzz::twin_target();
    int missed = 0;
    const std::vector<std::pair<std::string, Answer>> wanted{{"throw", Answer::survivor}, {"memory", Answer::survivor}, {"hang", Answer::survivor},
                                                             {"crash", Answer::survivor}, {"accept", Answer::accepted}, {"other", Answer::refused}};
    for (const auto& [word, expected] : wanted) {
        if ((word == "memory" && !fuzz::memory_is_limited()) || answer(twin, word, 1) == expected) continue;
        ++missed;
        fmt::print(stderr, "the planted fault '{}' was not reported\n", word);
    }
    const Target longer{"longer", {"accept"}, [](const std::string& bytes) {
                            if (bytes.starts_with("accept") && bytes.size() > 6) throw std::runtime_error("longer than a seed");
                        }};
    if (try_mutations(longer, 2000, 1, finds).survivors == 0) ++missed, fmt::print(stderr, "no damaged seed met the planted fault\n");
    fmt::print("counts: 5 faults planted, {} missed\n", missed);
    return missed == 0 ? 0 : 1;
}

int body(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "--twin") return run_twin(words[1]);
    if (words.size() == 1) return run_kept(words[0]);
    if (words.size() < 3 || words[0] != "--mutate")
        throw InputError("", "command line", "fuzz_regression FOLDER | --mutate COUNT FINDS [SEED [TARGET]] | --twin FINDS");
    return run_mutations(std::atol(words[1].c_str()), words[2], words.size() > 3 ? std::strtoull(words[3].c_str(), nullptr, 10) : 1, words.size() > 4 ? words[4] : "");
}

}  // namespace

int main(int argc, char** argv) { return cleave::run_program("fuzz_regression", body, argc, argv); }
