#include "validation/studies/contact_fields.hpp"

#include "solver/contact/half_space.hpp"
#include "solver/contact/stroh_table.hpp"
#include "validation/analytic/gauss_rule.hpp"
#include "validation/analytic/half_space_fourier.hpp"
#include "validation/analytic/half_space_isotropic.hpp"
#include "validation/solutions.hpp"
#include "validation/studies/contact_surfaces.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace cleave::validation {

namespace {

using contact::HalfSpaceField;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

const Vector3d force(0.4, -0.3, 1);  // N; 27 degrees off the normal

/// Depth over distance from the axis: 2.3 to 0.14, and the axis.
const std::vector<Vector3d> places{{0, 0, 0.8}, {0.4, 0.2, 1}, {0.9, -0.5, 0.6}, {-1.2, 0.4, 0.4}, {1.5, 1.1, 0.26}};

struct Load {
    std::string name;
    double radius;
};
const std::vector<Load> loads{{"point", 0}, {"Hertz", 1}};

/// Steps of the differences below, over the depth. Along a surface under which fibres stand, stress s^-2 with |s| down to w z, w = 0.17 the
/// smallest Im p of the catalogue (IM7/8552): a fourth-order difference leaves 24 step^4 / w^5 in the few directions where s is that small,
/// at most 1e-5 of |stress|/|x|, and amplifies the sum's own 1e-10 by 1.5 |x| / (step z), at most 4,000. Steps of 1e-2 leave 120 times the
/// first, steps of 1e-3 three times the second.
constexpr double step = 3e-3;

/// Displacement and its gradient, as functions of place.
struct Fields {
    std::function<Vector3d(const Vector3d&)> displacement;
    std::function<Matrix3d(const Vector3d&)> gradient;
};

Matrix3d stress(const material::Stiffness& c, const Matrix3d& gradient) {
    return material::stress_from_voigt(c * material::strain_to_voigt(0.5 * (gradient + gradient.transpose())));
}

/// Sum of a function's values at x +- h, x +- 2h along each axis with the fourth-order weights of a derivative: calls use(axis, value).
template <typename Value, typename Use>
void differentiate(const std::function<Value(const Vector3d&)>& of, const Vector3d& x, double h, const Use& use) {
    for (int b = 0; b < 3; ++b) {
        const Vector3d e = h * Vector3d::Unit(b);
        const Value difference = (8 * (of(x + e) - of(x - e)) - (of(x + 2 * e) - of(x - 2 * e))) / (12 * h);
        use(b, difference);
    }
}

/// Lame's lambda, and what stands in its place, a tenth less: the material of the twins that must fail. Still positive definite, and
/// isotropic where `c` is.
material::Stiffness softer_across(material::Stiffness c) {
    c.topLeftCorner<3, 3>().array() -= 0.1 * c(0, 1);
    return c;
}

double differentiation_error(const Fields& fields, const material::Stiffness& c) {
    double worst = 0;
    for (const Vector3d& x : places) {
        Matrix3d gradient;
        differentiate<Vector3d>(fields.displacement, x, step * x[2], [&](int b, const Vector3d& slope) { gradient.col(b) = slope; });
        worst = std::max(worst, relative(stress(c, fields.gradient(x)), stress(c, gradient)));
    }
    return worst;
}

/// |div sigma| times the distance from the contact, over |sigma|.
double divergence(const Fields& fields, const material::Stiffness& c) {
    double worst = 0;
    const std::function<Matrix3d(const Vector3d&)> sigma = [&](const Vector3d& x) { return stress(c, fields.gradient(x)); };
    for (const Vector3d& x : places) {
        Vector3d sum = Vector3d::Zero();
        differentiate<Matrix3d>(sigma, x, step * x[2], [&](int b, const Matrix3d& slope) { sum += slope.col(b); });
        worst = std::max(worst, sum.norm() * x.norm() / sigma(x).norm());
    }
    return worst;
}

/// |F - integral of -sigma n over a hemisphere of radius 1.6| / |F|.
double load_imbalance(const Fields& fields, const material::Stiffness& c) {
    constexpr int turns = 48;
    constexpr double radius = 1.6;
    Vector3d sum = Vector3d::Zero();
    for (const auto& [t, weight] : analytic::gauss_rule(24)) {
        const double cosine = (1 + t) / 2, sine = std::sqrt(1 - cosine * cosine);
        for (int k = 0; k < turns; ++k) {
            const double phi = 2 * pi * (k + 0.5) / turns;
            const Vector3d n(sine * std::cos(phi), sine * std::sin(phi), cosine);
            sum -= weight / 2 * 2 * pi / turns * radius * radius * (stress(c, fields.gradient(radius * n)) * n);
        }
    }
    return relative(sum, force);
}

/// The Stroh sum of a point force with a fixed number of directions, wherever the place is.
Fields fixed_directions(const contact::StrohTable& table, int level) {
    const auto gradient = [&table, level](const Vector3d& x) {
        Matrix3d sum = Matrix3d::Zero();
        for (const contact::StrohDirection& one : table.level(level))
            for (int root = 0; root < 3; ++root) {
                const std::complex<double> p = one.root[root], s = one.cosine * x[0] + one.sine * x[1] + p * x[2];
                const Eigen::Vector3cd slope = one.matrix[root] * force.cast<std::complex<double>>() / (s * s);
                sum.col(0) += one.cosine * slope.real();
                sum.col(1) += one.sine * slope.real();
                sum.col(2) += (p * slope).real();
            }
        return Matrix3d(sum / (2 * pi * static_cast<double>(table.level(level).size())));
    };
    return {{}, gradient};
}

Fields of_solver(const HalfSpaceField& field) {
    return {[field](const Vector3d& x) { return field.displacement(x); }, [field](const Vector3d& x) { return field.gradient(x); }};
}

Fields of_fourier(const analytic::FourierHalfSpace& half_space, double radius) {
    const auto response = [&half_space, radius](const Vector3d& x) { return half_space.response(plain(force), radius, plain(x)); };
    return {[response](const Vector3d& x) { return eigen(response(x).displacement); },
            [response](const Vector3d& x) {
                const analytic::Gradient g = response(x).gradient;
                return (Matrix3d() << g[0][0], g[0][1], g[0][2], g[1][0], g[1][1], g[1][2], g[2][0], g[2][1], g[2][2]).finished();
            }};
}

/// Boussinesq and Cerruti as printed, summed over the circle for Hertz's pressure.
Vector3d printed(const material::Stiffness& c, double radius, const Vector3d& x) {
    const double G = c(5, 5), nu = c(0, 1) / (2 * (c(0, 1) + G));
    const analytic::IsotropicHalfSpace load{G, nu, plain(force), radius};
    return eigen(radius > 0 ? analytic::hertz_displacement_by_quadrature(load, plain(x)) : analytic::point_force_displacement(load, plain(x)));
}

class ContactFields final : public Study {
public:
    ContactFields(bool closed, std::vector<ContactSurface> surfaces) : closed_(closed), surfaces_(std::move(surfaces)) {}

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        const bool full = context.level == "full";
        for (const ContactSurface& surface : full ? contact_surfaces() : surfaces_)
            if (surface.isotropic || !closed_)
                for (const Load& load : loads) measure(surface, load, outcome);
        if (closed_) return outcome;
        // 1e-5 is finer than the load's 1e-3; every material.
        for (const ContactSurface& surface : full ? contact_surfaces() : one_surface_of_each()) {
            const auto carried = [&](const material::Stiffness& c) {
                const contact::HalfSpaceOptions options{.form = contact::HalfSpaceForm::stroh, .accuracy = 1e-5};
                return load_imbalance(of_solver(contact::half_space_field(c, {.force = force}, options)), surface.stiffness);
            };
            outcome.values.push_back({"load_imbalance_of_catalogue", "stroh", surface.name, carried(surface.stiffness)});
            outcome.values.push_back({"load_imbalance_of_catalogue", "softer_across", surface.name, carried(softer_across(surface.stiffness))});
        }
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return stiffnesses(surfaces_); }

private:
    /// What the fields of one load are compared with, place by place.
    struct Exact {
        std::vector<Vector3d> displacement;
        std::vector<Matrix3d> stress;
    };

    static Exact exact_fields(const ContactSurface& surface, double radius) {
        const analytic::FourierHalfSpace fourier(plain_stiffness(surface.stiffness));
        const Fields transform = of_fourier(fourier, radius);
        Exact exact;
        for (const Vector3d& x : places) {
            exact.displacement.push_back(transform.displacement(x));
            exact.stress.push_back(stress(surface.stiffness, transform.gradient(x)));
        }
        return exact;
    }

    void measure(const ContactSurface& surface, const Load& load, StudyOutcome& outcome) const {
        const std::string place = surface.name + ", " + load.name, method = closed_ ? "closed" : "stroh";
        const contact::ContactLoad patch{.force = force, .radius = load.radius};
        contact::HalfSpaceOptions options{.form = closed_ ? contact::HalfSpaceForm::closed : contact::HalfSpaceForm::stroh};
        const auto add = [&](const std::string& quantity, const std::string& by, double value) { outcome.values.push_back({quantity, by, place, value}); };
        const Exact exact = exact_fields(surface, load.radius);
        const auto judge = [&](const std::string& by, const Fields& fields) {
            double u = 0, sigma = 0, of_book = 0;
            for (std::size_t k = 0; k < places.size(); ++k) {
                u = std::max(u, relative(fields.displacement(places[k]), exact.displacement[k]));
                sigma = std::max(sigma, relative(stress(surface.stiffness, fields.gradient(places[k])), exact.stress[k]));
                if (surface.isotropic) of_book = std::max(of_book, relative(fields.displacement(places[k]), printed(surface.stiffness, load.radius, places[k])));
            }
            add("displacement_error", by, u);
            add("stress_error", by, sigma);
            if (surface.isotropic) add("boussinesq_error", by, of_book);
            add("load_imbalance", by, load_imbalance(fields, surface.stiffness));
        };
        const auto judge_slopes = [&](const std::string& by, const Fields& fields) {
            add("differentiation_error", by, differentiation_error(fields, surface.stiffness));
            add("divergence", by, divergence(fields, surface.stiffness));
        };
        judge(method, of_solver(contact::half_space_field(surface.stiffness, patch, options)));
        const Fields of_softer = of_solver(contact::half_space_field(softer_across(surface.stiffness), patch, options));
        judge("softer_across", of_softer);
        // Differences amplify the sum's own error by the distance over the step: a finer sum.
        options.accuracy = 1e-10;
        const Fields fine = of_solver(contact::half_space_field(surface.stiffness, patch, options));
        judge_slopes(method, fine);
        judge_slopes("softer_across", {fine.displacement, of_softer.gradient});
        if (closed_ || load.radius > 0) return;
        const contact::StrohTable table(surface.stiffness, 256);
        add("load_imbalance", "stroh_256", load_imbalance(fixed_directions(table, 3), surface.stiffness));
    }

    bool closed_;
    std::vector<ContactSurface> surfaces_;  // of level quick
};

}  // namespace

StudyInfo contact_fields_study() {
    return {"contact_fields",
            "half-space fields of every material: against analytic half-spaces, against their own derivatives, and the force they carry",
            {"form", "surfaces"},
            {{"displacement_error", dimension::none}, {"stress_error", dimension::none}, {"boussinesq_error", dimension::none},
             {"differentiation_error", dimension::none}, {"divergence", dimension::none}, {"load_imbalance", dimension::none},
             {"load_imbalance_of_catalogue", dimension::none}},
            {"closed", "stroh", "stroh_256", "softer_across"},
            [](TableReader& table) -> std::shared_ptr<const Study> {
                const bool closed = table.choice("form", {"closed", "stroh"}) == "closed";
                return std::make_shared<ContactFields>(closed, read_surfaces(table));
            }};
}

}  // namespace cleave::validation
