#include "validation/case.hpp"
#include "validation/suite.hpp"
#include "validation/test/fuzz/target.hpp"

namespace cleave::fuzz {

Target case_target() {
    return {"case", texts_in(validation::case_folder(), ".toml"), [](const std::string& bytes) {
                // Not its symmetry class as well: that is a search over directions, half a minute an input with sanitizers.
                validation::read_cases(input_file("input.toml", bytes).string(), {});
            }};
}

}  // namespace cleave::fuzz
