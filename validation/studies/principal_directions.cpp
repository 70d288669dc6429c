#include "validation/studies/principal_directions.hpp"

#include "solver/fracture/criterion.hpp"
#include "solver/material/material.hpp"
#include "validation/analytic/principals.hpp"
#include "validation/solutions.hpp"

#include <cmath>

namespace cleave::validation {

namespace {

/// One criterion's answer.
struct Answer {
    analytic::Point direction;
    double gap;
};

class PrincipalDirections final : public Study {
public:
    PrincipalDirections(const material::Stiffness& stiffness, const std::array<double, 3>& principal, double turn)
        : stiffness_(stiffness) {
        const double c = std::cos(turn), s = std::sin(turn);
        stress_ = {c * c * principal[0] + s * s * principal[1], s * s * principal[0] + c * c * principal[1], principal[2], 0, 0,
                   c * s * (principal[0] - principal[1])};
    }

    StudyOutcome run(const StudyContext&) const override {
        StudyOutcome outcome;
        add("solver", by_solver(fracture::Criterion::stress), by_solver(fracture::Criterion::strain), outcome);
        const analytic::Voigt strain = analytic::strain_under(plain_stiffness(stiffness_), stress_);
        add("analytic", by_jacobi(analytic::stress_tensor(stress_)), by_jacobi(analytic::strain_tensor(strain)), outcome);
        add("tensor_shear", by_jacobi(analytic::stress_tensor(stress_)), by_jacobi(analytic::stress_tensor(strain)), outcome);
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return {stiffness_}; }

private:
    Answer by_solver(fracture::Criterion criterion) const {
        const material::Voigt stress(stress_.data());
        const fracture::Principal found = fracture::rankine(stress, material::compliance(stiffness_) * stress, criterion);
        return {{found.direction[0], found.direction[1], found.direction[2]}, found.gap};
    }

    static Answer by_jacobi(const analytic::Gradient& tensor) {
        const analytic::Principals found = analytic::principals(tensor);
        return {found.direction[0], found.gap()};
    }

    static void add(const std::string& method, const Answer& stress, const Answer& strain, StudyOutcome& outcome) {
        const analytic::Point x{1, 0, 0};
        outcome.values.push_back({"direction_difference", method, "", analytic::angle_between(stress.direction, strain.direction)});
        outcome.values.push_back({"direction", method, "stress", analytic::angle_between(stress.direction, x)});
        outcome.values.push_back({"direction", method, "strain", analytic::angle_between(strain.direction, x)});
        outcome.values.push_back({"gap", method, "stress", stress.gap});
        outcome.values.push_back({"gap", method, "strain", strain.gap});
    }

    material::Stiffness stiffness_;
    analytic::Voigt stress_{};
};

std::shared_ptr<const Study> read(TableReader& study) {
    TableReader table = study.table("material");
    const material::Material material = material::read_material(table);
    const std::vector<double> principal = study.numbers("principal_stress");
    if (principal.size() != 3) study.fail("principal_stress", "three numbers");
    return std::make_shared<PrincipalDirections>(material.stiffness, std::array{principal[0], principal[1], principal[2]},
                                                 study.angle_or("turned", 0));
}

}  // namespace

StudyInfo principal_directions_study() {
    return {"principal_directions",
            "Rankine by stress and by strain under one stress: how far apart the two cracks are",
            {"material", "principal_stress", "turned"},
            {{"direction_difference", dimension::none, true}, {"direction", dimension::none, true}, {"gap", dimension::none}},
            {"solver", "analytic", "tensor_shear"},
            read,
            {"analytic", "tensor_shear"}};
}

}  // namespace cleave::validation
