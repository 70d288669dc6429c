#include "validation/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleave::validation {

namespace {

using Numbers = std::vector<std::size_t>;  // of rows

double error_of(const Row& row) { return row.relative ? row.measurement.relative_error : row.measurement.absolute_error; }

/// Rows about the same thing, in the order in which it first comes up.
std::vector<Numbers> groups_of(const std::vector<Row>& rows) {
    std::vector<Numbers> groups;
    std::map<std::array<std::string, 4>, std::size_t> known;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].must_fail) continue;
        const auto [at, fresh] = known.emplace(std::array{rows[i].quantity, rows[i].component, rows[i].unit, rows[i].place}, groups.size());
        if (fresh) groups.emplace_back();
        groups[at->second].push_back(i);
    }
    return groups;
}

class Group {
public:
    /// What a line shows is of the finest mesh, judged where anything is: those rows go first.
    Group(const std::vector<Row>& rows, Numbers numbers) : rows_(rows), numbers_(std::move(numbers)) {
        const auto rank = [&](std::size_t i) { return std::pair(rows_[i].resolution.size, rows_[i].band.empty()); };
        std::stable_sort(numbers_.begin(), numbers_.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    }

    std::vector<Comparison> lines() const {
        std::vector<Comparison> result;
        const std::vector<std::string> particles = solvers(Side::particles), elements = solvers(Side::fem);
        for (const std::string& solver : particles) result.push_back(line(solver, beside(solver, elements)));
        for (const std::string& solver : elements)
            if (std::none_of(result.begin(), result.end(), [&](const Comparison& one) { return one.fem && one.fem->by == solver; }))
                result.push_back(line("", solver));
        if (result.empty()) result.push_back(line("", ""));
        return result;
    }

private:
    std::vector<std::string> solvers(Side side) const {
        std::vector<std::string> names;
        for (const std::size_t i : numbers_)
            if (rows_[i].side == side && std::find(names.begin(), names.end(), rows_[i].solver) == names.end()) names.push_back(rows_[i].solver);
        return names;
    }

    /// The finite elements a particle solver is compared with: those that a check or a measurement names, else quadratic ones.
    std::string beside(const std::string& solver, const std::vector<std::string>& elements) const {
        for (const std::size_t i : numbers_) {
            if (rows_[i].solver != solver) continue;
            if (rows_[i].reference_side == Side::fem) return rows_[i].reference_source;
            for (const Also& also : rows_[i].also)
                if (also.side == Side::fem) return also.source;
        }
        if (std::find(elements.begin(), elements.end(), "fem.p2") != elements.end()) return "fem.p2";
        return elements.empty() ? "" : elements.front();
    }

    Comparison line(const std::string& particles, const std::string& fem) const {
        const Row& first = rows_[numbers_.front()];
        Comparison one{first.quantity, first.component, first.unit, first.place, {}, {}, {}, {}, {}, {}, {}};
        for (const std::size_t i : numbers_) {
            const Row& row = rows_[i];
            if (row.solver != particles && row.solver != fem && row.side != Side::mathematics) continue;
            one.rows.push_back(i);
            state(row.side, row.solver, row.measurement.value, one);
        }
        for (const std::size_t i : one.rows) add_reference(i, one);
        for (const std::size_t i : one.rows)
            for (const Also& also : rows_[i].also) add_pair(rows_[i].side, also.side, also.source, also.value, {also.error, also.relative, {}}, one);
        if (first.norm.empty()) subtract(first.unit == "deg", one);
        return one;
    }

    static std::optional<Statement>& statement(Side side, Comparison& one) {
        return side == Side::particles ? one.particles : side == Side::fem ? one.fem : one.mathematics;
    }

    static void state(Side side, const std::string& by, const std::optional<double>& value, Comparison& one) {
        if (by.empty()) return;
        std::optional<Statement>& known = statement(side, one);
        if (!known) known = Statement{by, value};
        if (!known->value) known->value = value;
    }

    void add_reference(std::size_t i, Comparison& one) const {
        const Row& row = rows_[i];
        if (!row.reference_side) return;
        add_pair(row.side, *row.reference_side, row.reference_source, row.measurement.reference, {error_of(row), row.relative, i}, one);
    }

    static void add_pair(Side of, Side against, const std::string& source, const std::optional<double>& value, const Difference& difference,
                         Comparison& one) {
        state(against, source, value, one);
        const std::optional<Statement>& known = statement(against, one);
        if (!known || known->by != source || of == against) return;
        std::optional<Difference>& pair = of == Side::particles ? (against == Side::fem ? one.particles_fem : one.particles_mathematics) : one.fem_mathematics;
        if (of != Side::mathematics && !pair) pair = difference;
    }

    /// The difference of two single numbers, relative unless they are angles or the second is zero.
    static void subtract(bool absolute, Comparison& one) {
        const auto take = [&](const std::optional<Statement>& a, const std::optional<Statement>& b, std::optional<Difference>& pair) {
            if (pair || !a || !b || !a->value || !b->value) return;
            const bool relative = !absolute && *b->value != 0 && !(one.mathematics && one.mathematics->value == 0);
            pair = Difference{std::abs(*a->value - *b->value) / (relative ? std::abs(*b->value) : 1), relative, {}};
        };
        take(one.particles, one.fem, one.particles_fem);
        take(one.particles, one.mathematics, one.particles_mathematics);
        take(one.fem, one.mathematics, one.fem_mathematics);
    }

    const std::vector<Row>& rows_;
    Numbers numbers_;
};

}  // namespace

const char* name(Side side) {
    switch (side) {
        case Side::particles: return "particles";
        case Side::fem: return "fem";
        case Side::mathematics: return "mathematics";
    }
    return "particles";
}

std::vector<Comparison> compare_sides(const std::vector<Row>& rows) {
    std::vector<Comparison> lines;
    for (Numbers& numbers : groups_of(rows))
        for (Comparison& line : Group(rows, std::move(numbers)).lines()) lines.push_back(std::move(line));
    return lines;
}

}  // namespace cleave::validation
