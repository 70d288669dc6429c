#include "benchmarks/bodies.hpp"

namespace cleave::benchmarks {

const SubdivisionCase& LazyCase::get() {
    constexpr std::size_t large = 500'000;
    if (made_) return *made_;
    made_ = std::make_unique<SubdivisionCase>(make_());
    if (made_->mesh.tets.size() >= large) {
        if (*large_ != nullptr && *large_ != this) (*large_)->made_.reset();
        *large_ = this;
    }
    return *made_;
}

std::shared_ptr<LazyCase> Bodies::cube(int cells) {
    std::shared_ptr<LazyCase>& body = cubes_[cells];
    if (!body) body = add([cells] { return cube_case(cells); });
    return body;
}

std::shared_ptr<LazyCase> Bodies::pot() {
    if (!pot_) pot_ = add(pot_case);
    return pot_;
}

}  // namespace cleave::benchmarks
