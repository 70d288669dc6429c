#include "validation/ladder.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::validation {

namespace {

template <class Size>
bool falls(const std::vector<LadderStep>& ladder, Size size) {
    return !ladder.empty() && size(ladder.back()) > 0 &&
           std::adjacent_find(ladder.begin(), ladder.end(), [&](const LadderStep& a, const LadderStep& b) { return size(b) >= size(a); }) == ladder.end();
}

}  // namespace

std::vector<double> representative_sizes(const std::vector<LadderStep>& ladder, OrderOver over) {
    const auto nominal = [](const LadderStep& step) { return step.resolution.size; };
    const auto by_count = [&](const LadderStep& step) {
        const double finest = static_cast<double>(ladder.back().resolution.particles), own = static_cast<double>(step.resolution.particles);
        return finest > 0 && own > 0 ? (nominal(ladder.back()) > 0 ? nominal(ladder.back()) : 1) * std::cbrt(finest / own) : 0.0;
    };
    std::vector<double> sizes;
    const bool count = over == OrderOver::count ? falls(ladder, by_count) : !falls(ladder, nominal) && falls(ladder, by_count);
    const bool any = count || falls(ladder, nominal);
    for (const LadderStep& step : ladder) sizes.push_back(!any ? 0 : count ? by_count(step) : nominal(step));
    return sizes;
}

void finish_ladder(Row& row, OrderOver over) {
    const std::vector<double> sizes = representative_sizes(row.ladder, over);
    std::vector<Refinement> refinements;
    for (std::size_t i = 0; i < row.ladder.size(); ++i) {
        row.ladder[i].h = sizes[i];
        refinements.push_back({sizes[i], row.ladder[i].value, row.ladder[i].error});
    }
    row.convergence = study_convergence(refinements);
    if (over != OrderOver::none && row.convergence) row.measurement.order = row.convergence->order;
}

}  // namespace cleave::validation
