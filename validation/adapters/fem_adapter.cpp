#include "reference_fem/crack_direction.hpp"
#include "reference_fem/vtu.hpp"
#include "solver/input/input_error.hpp"
#include "validation/adapters/fem_crack.hpp"
#include "validation/adapters/fem_problem.hpp"
#include "validation/adapters/sources.hpp"

#include <cmath>

namespace cleave::validation {

namespace {

Samples gather(const std::vector<fem::FieldSample>& list) {
    Samples samples;
    for (const fem::FieldSample& one : list) {
        samples.position.push_back(one.position);
        samples.weight.push_back(one.weight > 0 ? one.weight : 1);
        samples.displacement.push_back(one.displacement);
        samples.strain.push_back(one.strain);
        samples.stress.push_back(one.stress);
    }
    return samples;
}

class FemSource final : public FieldSource {
public:
    FemSource(const Case& of, const geometry::Body& body, const fem::Options& options, fem::Solution solution, double size)
        : of_(of), body_(body), options_(options), solution_(std::move(solution)), size_(size), samples_(gather(solution_.quadrature_samples(3))),
          crack_(of, body, [&of](const geometry::Body& moved) { return fem_problem(of, moved); }, solution_, options) {}

    const Samples& everywhere() const override { return samples_; }
    Samples at(const std::vector<Point>& points) const override {
        return in_the_body([&] { return solution_.recovered_at(points); });
    }
    Samples inside(const std::vector<Point>& points) const override {
        return in_the_body([&] { return solution_.at(points); });
    }
    double scalar(const std::string& quantity) const override {
        if (quantity == "energy") return solution_.energy();
        if (quantity == "external_work") return solution_.external_work();
        if (quantity == "residual") return solution_.record().relative_residual;
        if (quantity == "estimated_error") return solution_.estimated_error();
        if (quantity == "energy_release_rate") return crack_.energy_release_rate();
        if (quantity == "energy_release_rate_domain") return crack_.energy_release_rate_domain();
        if (quantity == "crack_opening") return crack_opening();
        throw InputError(of_.file, quantity, "a quantity that finite elements have");
    }
    double at_front(const std::string& quantity, const std::string& component, const Point& place) const override {
        return crack_.at_front(quantity, component, place);
    }
    PrincipalAxis principal_stress(const Point& point) const override {
        const fem::PrincipalStress principal = fem::largest_principal_stress(solution_.recovered_at({point}).front().stress);
        return {principal.direction, principal.gap};
    }
    std::string vtu() const override { return fem::vtu_text(solution_); }
    Resolution resolution() const override { return {size_, solution_.record().cells, solution_.record().dofs}; }

private:
    template <class Call>
    Samples in_the_body(const Call& call) const {
        try {
            return gather(call());
        } catch (const fem::Error& error) {
            throw InputError(of_.file, "at", std::string("points in the body: ") + error.what());
        }
    }
    /// Mean over the lips' vertices within 0.3 radii of the centre, scaled by the ellipse sqrt(1 - r^2/a^2) they should lie on.
    double crack_opening() const {
        const Point normal = station_near(*of_.shape, {}).place.axes[1];
        const double a = of_.shape->length("crack_radius");
        const std::vector<Point> x = solution_.vertices(), u = solution_.vertex_displacements();
        const auto dot = [&](const Point& p) { return p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2]; };
        std::array<double, 2> sum{}, count{};
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double r = std::hypot(x[i][0], x[i][1], x[i][2]);
            if (r > 0.3 * a || std::abs(dot(x[i])) > 1e-9 * a) continue;
            const double open = dot(u[i]) / std::sqrt(1 - r * r / (a * a));
            const std::size_t lip = open > 0 ? 0 : 1;
            sum[lip] += std::abs(open), count[lip] += 1;
        }
        return sum[0] / count[0] + sum[1] / count[1];
    }

    const Case& of_;
    geometry::Body body_;
    fem::Options options_;
    fem::Solution solution_;
    double size_;
    Samples samples_;
    FemCrack crack_;
};

}  // namespace

std::unique_ptr<FieldSource> run_fem(const Case& of, const geometry::Body& body, double size, const std::string& solver, SolveNote& note) {
    fem::Options options;
    options.degree = solver == "fem.p1" ? 1 : 2;
    try {
        fem::Solution solution = fem::solve(fem_problem(of, body), options);
        const fem::SolveRecord& record = solution.record();
        note = {solver, record.solver, record.cells, record.dofs, record.iterations, record.relative_residual, record.seconds, record.matrix_bytes};
        return std::make_unique<FemSource>(of, body, options, std::move(solution), size);
    } catch (const fem::Error& error) {
        throw InputError(of.file, solver, std::string("a problem that can be solved: ") + error.what());
    }
}

}  // namespace cleave::validation
