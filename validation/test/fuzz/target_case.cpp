#include "validation/case.hpp"
#include "validation/suite.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

Target case_target() {
    return {"case", texts_in(validation::case_folder(), ".toml"), [](const std::string& bytes) {
                for (const validation::Case& one : validation::read_cases(input_file("input.toml", bytes).string(), {})) (void)one.symmetry();
            }};
}

}  // namespace cleave::fuzz
