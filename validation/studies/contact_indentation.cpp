#include "validation/studies/contact_indentation.hpp"

#include "solver/contact/indentation.hpp"
#include "validation/analytic/half_space_fourier.hpp"
#include "validation/solutions.hpp"
#include "validation/studies/contact_surfaces.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace cleave::validation {

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// The transversely isotropic example of Willis's formula, axis along the normal: C11, C33, C13, C12, C44 = 16, 6, 5, 7, 2 Pa.
ContactSurface willis_example() {
    material::Stiffness c = material::Stiffness::Zero();
    c.topLeftCorner<3, 3>() << 16, 7, 5, 7, 16, 5, 5, 5, 6;
    c.diagonal().tail<3>() << 2, 2, 4.5;
    return {"transversely isotropic", c, false};
}

double h_error(const contact::HalfSpace& solver, const analytic::FourierHalfSpace& fourier, double turn) {
    double worst = 0;
    for (int k = 0; k < 36; ++k) {
        const double phi = 2 * pi * k / 36;
        worst = std::max(worst, std::abs(contact::surface_compliance(solver, phi) / fourier.surface_compliance(phi + turn) - 1));
    }
    return worst;
}

/// Second derivatives of the surface's normal displacement under Hertz's pressure (p0 = 1, a = 1), by steps of 0.3 a: the displacement is
/// a paraboloid, so the step does not matter. `turned`: against the paraboloid with its axes swapped.
double paraboloid_error(const ContactSurface& surface, const analytic::FourierHalfSpace& fourier, bool turned) {
    const contact::HalfSpaceField field =
        contact::half_space_field(surface.stiffness, {.force = {0, 0, 2 * pi / 3}, .radius = 1}, {.form = contact::HalfSpaceForm::stroh});
    const auto u = [&](double x, double y) { return field.displacement({x, y, 0})[2]; };
    const double s = 0.3, centre = u(0, 0);
    Eigen::Matrix2d bend, exact;
    bend(0, 0) = (u(s, 0) + u(-s, 0) - 2 * centre) / (s * s);
    bend(1, 1) = (u(0, s) + u(0, -s) - 2 * centre) / (s * s);
    bend(0, 1) = bend(1, 0) = (u(s, s) + u(-s, -s) - u(s, -s) - u(-s, s)) / (4 * s * s);
    const auto integral = fourier.curvature_integral();
    exact << integral[0][0], integral[0][1], integral[1][0], integral[1][1];
    if (turned) exact = exact.reverse().eval();
    return relative(bend, -exact / 4);
}

class ContactIndentation final : public Study {
public:
    explicit ContactIndentation(std::vector<ContactSurface> surfaces) : surfaces_(std::move(surfaces)) {}

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        std::vector<ContactSurface> with_example = context.level == "full" ? contact_surfaces() : surfaces_;
        with_example.push_back(willis_example());
        for (const ContactSurface& surface : with_example) {
            const contact::HalfSpace solver(surface.stiffness, Vector3d::UnitZ(), {.form = contact::HalfSpaceForm::stroh});
            const analytic::FourierHalfSpace fourier(plain_stiffness(surface.stiffness));
            outcome.values.push_back({"indentation_modulus", "stroh", surface.name, contact::indentation_modulus(solver)});
            outcome.values.push_back({"indentation_modulus", "analytic", surface.name, fourier.indentation_modulus(256)});
            outcome.values.push_back({"surface_compliance_error", "stroh", surface.name, h_error(solver, fourier, 0)});
            outcome.values.push_back({"surface_compliance_error", "turned", surface.name, h_error(solver, fourier, pi / 4)});
            outcome.values.push_back({"paraboloid_error", "stroh", surface.name, paraboloid_error(surface, fourier, false)});
            outcome.values.push_back({"paraboloid_error", "turned", surface.name, paraboloid_error(surface, fourier, true)});
        }
        outcome.artifacts.push_back(draw(surfaces_, context));
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return stiffnesses(surfaces_); }

private:
    /// h over its mean, by direction.
    static Artifact draw(const std::vector<ContactSurface>& surfaces, const StudyContext& context) {
        std::filesystem::create_directories(context.out / context.folder);
        std::ofstream file(context.out / context.folder / "surface_compliance.csv");
        std::string header = "direction / deg";
        std::vector<contact::HalfSpace> half_spaces;
        for (const ContactSurface& surface : surfaces) {
            header += "," + surface.name;
            half_spaces.emplace_back(surface.stiffness, Vector3d::UnitZ());
        }
        file << header << "\n";
        for (int degree = 0; degree <= 180; degree += 5) {
            std::string line = std::to_string(degree);
            for (const contact::HalfSpace& half_space : half_spaces)
                line += fmt::format(",{:.6g}", contact::surface_compliance(half_space, degree * pi / 180) * contact::indentation_modulus(half_space) / 2);
            file << line << "\n";
        }
        return {context.folder + "/surface_compliance.csv", "Compliance of the surface by direction, over its mean", "direction / deg", "h / mean h"};
    }

    std::vector<ContactSurface> surfaces_;  // of level quick
};

}  // namespace

StudyInfo contact_indentation_study() {
    return {"contact_indentation",
            "indentation modulus, surface compliance by direction and the paraboloid under Hertz's pressure, by Stroh and by Barnett and Lothe",
            {"surfaces"},
            {{"indentation_modulus", dimension::pressure}, {"surface_compliance_error", dimension::none}, {"paraboloid_error", dimension::none}},
            {"stroh", "analytic", "turned"},
            [](TableReader& table) -> std::shared_ptr<const Study> { return std::make_shared<ContactIndentation>(read_surfaces(table)); },
            {"analytic", "turned"}};
}

}  // namespace cleave::validation
