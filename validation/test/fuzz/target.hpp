// One kind of input that users hand to Cleave, as fuzzers and the regression test try it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cleave::fuzz {

/// Reads one input as the programs do. The answer must be a parsed result or InputError: any other exception, a crash, a hang, more
/// than 2 GB or undefined behaviour is a find.
struct Target {
    std::string name;                                     ///< of the fuzzer, and of the folder of its regression inputs
    std::vector<std::string> seeds;                       ///< inputs that are accepted: what mutation starts from
    std::function<void(const std::string& bytes)> read;
};

// Text files.
Target material_target();
Target scene_target();
Target case_target();
// Meshes, by ending: read, checked, a surface parted at its sharp edges.
Target msh_target();
Target medit_target();
Target vtu_target();
Target stl_target();
Target obj_target();
Target fem_msh_target();  ///< the FEM's own reader; what both accept must be the same tets
// What earlier runs left.
Target checkpoint_target();  ///< with its checksum made right, so that mutations reach what stands behind it
Target results_target();      ///< results.json, merged and compared by cleave validate
Target stored_case_target();  ///< cases/NAME.json, taken up by cleave validate --reuse
Target report_target();       ///< results.json, drawn by cleave report
Target samples_target();      ///< the CSV files it draws
Target table_target();        ///< statistics.json and timings.json, printed by cleave simulate --table

Target twin_target();  ///< must fail: it breaks each promise at a magic word

/// True where the input was accepted, false where it was refused in one line; everything else passes through.
bool accepts(const Target& target, const std::string& bytes);

/// Writes the input where a reader that wants a file finds it. The folder is this process's own, and empty in the beginning.
std::filesystem::path input_file(const std::string& name, const std::string& bytes);

/// All files of a folder that end in `ending`, by name.
std::vector<std::string> texts_in(const std::filesystem::path& folder, const std::string& ending);

}  // namespace cleave::fuzz
