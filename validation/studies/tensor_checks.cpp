#include "validation/studies/tensor_checks.hpp"

#include "solver/elasticity/crack_tip_field.hpp"
#include "solver/fracture/crack_tip.hpp"
#include "solver/input/input_error.hpp"
#include "solver/material/elastic_extremes.hpp"
#include "solver/material/stiffness.hpp"
#include "validation/adapters/level.hpp"
#include "validation/analytic/barnett_lothe.hpp"
#include "validation/analytic/plane_waves.hpp"
#include "validation/analytic/stretched_bar.hpp"
#include "validation/solutions.hpp"
#include "validation/studies/contact_surfaces.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cleave::validation {

namespace {

using analytic::CrackAxes;
using analytic::Point;
using material::Stiffness;
using std::numbers::pi;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// A NaN counts as the largest.
void raise(double& worst, double error) {
    if (!(error <= worst)) worst = error;
}

/// The classic factor of two: Kelvin's matrix, whose shear columns carry a factor sqrt 2 each, read as Voigt's. As stable as the tensor.
Stiffness kelvin_as_voigt(Stiffness c) {
    c.rightCols<3>() *= std::sqrt(2.0);
    c.bottomRows<3>() *= std::sqrt(2.0);
    return c;
}

std::shared_ptr<const geometry::Shape> shape_of(const std::string& keys) {
    TableReader table = TableReader::from_text(keys, "material_sweep");
    return geometry::read_shape(table);
}

SolutionCall call_of(const std::string& name) {
    SolutionCall call;
    call.name = name;
    call.where = "study";
    return call;
}

SurfaceLoad load_of(SurfaceLoad::Kind kind, std::vector<std::string> on) {
    SurfaceLoad load;
    load.kind = kind;
    load.on = std::move(on);
    return load;
}

Case body_of(const SweepTensor& tensor, const SweepBodies& bodies, const std::string& shape) {
    Case body;
    body.file = bodies.file;
    body.name = tensor.name;
    body.shape = shape_of(shape);
    body.materials[""].stiffness = tensor.stiffness;
    body.materials[""].density = tensor.density;
    body.particles.residual_tolerance = 1e-12;
    return body;
}

const char* const block = "shape = \"block\"\nextent = [\"1 m\", \"0.8 m\", \"0.6 m\"]";

/// Error of a solve that may find no answer, such as a tensor of so bad a condition that CG does not converge (an InputError of the
/// adapter). It is one of many here: its row fails by its name, and the sweep goes on.
template <class Measure>
double error_of(const Measure& measure) {
    try {
        return measure();
    } catch (const EnvironmentError&) {
        throw;
    } catch (const std::runtime_error&) {
        return undefined;
    }
}

double stress_error(const Samples& samples, const analytic::Field& exact) {
    return compare({"stress", ""}, samples, evaluate(exact, samples.position), "max").error;
}

/// Largest difference of stretch * modulus / stress from one.
double extension_error(const Samples& samples, double stretch_per_stress) {
    double worst = 0;
    for (const Voigt& strain : samples.strain) raise(worst, std::abs(strain[0] / stretch_per_stress - 1));
    return worst;
}

/// Axes of the front of a penny at an angle.
CrackAxes front_axes(const CrackAxes& about, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    CrackAxes axes{};
    for (std::size_t i = 0; i < 3; ++i) {
        axes[0][i] = c * about[0][i] + s * about[1][i];
        axes[1][i] = about[2][i];
        axes[2][i] = s * about[0][i] - c * about[1][i];  // ahead x normal
    }
    return axes;
}

Eigen::Matrix3d columns(const CrackAxes& axes) {
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i) matrix.col(i) = eigen(axes[static_cast<std::size_t>(i)]);
    return matrix;
}

/// Intensities are in the order II, I, III.
double by_stroh(const Stiffness& stiffness, const CrackAxes& axes, const Point& k) {
    return fracture::energy_release(stiffness, columns(axes), {.I = k[1], .II = k[0], .III = k[2]});
}

double by_tip_field(const Stiffness& stiffness, const CrackAxes& axes, const Point& k) {
    const elasticity::CrackTipField field(material::rotate_stiffness(stiffness, columns(axes).transpose()));
    const Eigen::Vector3d intensities = eigen(k);
    return 0.5 * intensities.dot(field.compliance() * intensities);
}

/// A penny of unit radius under a unit pressure and some shear.
struct Penny {
    CrackAxes about;  // two directions in its plane, the normal
    analytic::AnisotropicPenny exact;
};

Penny penny_of(const SweepTensor& tensor, double shear) {
    const CrackAxes about = analytic::axes_about(tensor.normal);
    Point traction{};
    for (std::size_t i = 0; i < 3; ++i) traction[i] = about[2][i] + shear * (0.5 * about[0][i] - 0.3 * about[1][i]);
    return {about, analytic::AnisotropicPenny(plain_stiffness(tensor.stiffness), tensor.normal, 1, traction)};
}

/// Mean of the solver's G over the front of a penny; `k_of` may spoil the intensities.
template <class Spoil>
double mean_by_stroh(const SweepTensor& tensor, const Penny& penny, const Spoil& k_of) {
    constexpr int places = 90;  // over half the front: the other half has the same
    double sum = 0;
    for (int place = 0; place < places; ++place) {
        const CrackAxes axes = front_axes(penny.about, pi * place / places);
        sum += by_stroh(tensor.stiffness, axes, k_of(penny.exact.intensities(axes)));
    }
    return sum / places;
}

Point as_it_is(const Point& k) { return k; }
Point modes_swapped(const Point& k) { return {k[0], k[2], k[1]}; }

}  // namespace

std::vector<TensorError> patch_errors(const SweepTensor& tensor, const SweepBodies& bodies) {
    Case body = body_of(tensor, bodies, block);
    body.loads = {load_of(SurfaceLoad::Kind::traction, {"right", "back", "top"}), load_of(SurfaceLoad::Kind::displacement, {"left", "front", "bottom"})};
    for (SurfaceLoad& load : body.loads) load.solution = call_of("linear_displacement");
    body.particles.solution = call_of("linear_displacement");
    const analytic::Field exact = make_field(*body.particles.solution, body);
    LevelSources sources(body, bodies.block_size, bodies.meshes);
    std::vector<TensorError> errors;
    for (const char* method : {"fem.p2", "sph.conforming", "sph.corrected", "sph.quadratic"})
        errors.push_back({"patch_error", method, error_of([&] { return stress_error(sources.get(method).everywhere(), exact); })});
    Case wrong = body;
    wrong.materials[""].stiffness = kelvin_as_voigt(tensor.stiffness);
    const analytic::Field other = make_field(*wrong.particles.solution, wrong);
    errors.push_back({"patch_error", "kelvin_as_voigt", stress_error(sources.get("fem.p2").everywhere(), other)});
    return errors;
}

std::vector<TensorError> bar_errors(const SweepTensor& tensor, const SweepBodies& bodies) {
    constexpr double stress = 1e6;
    const Eigen::Vector3d along = eigen(tensor.bar);
    const double exact = analytic::bar_modulus(plain_stiffness(tensor.stiffness), tensor.bar);
    Case body = body_of(tensor, bodies, block);
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(along, Eigen::Vector3d::UnitX()).toRotationMatrix();
    body.materials[""].stiffness = material::rotate_stiffness(tensor.stiffness, turn);
    body.free_body = true;
    body.loads = {load_of(SurfaceLoad::Kind::traction, {"right"}), load_of(SurfaceLoad::Kind::traction, {"left"})};
    body.loads[0].vector = {stress, 0, 0};
    body.loads[1].vector = {-stress, 0, 0};
    LevelSources sources(body, bodies.block_size, bodies.meshes);
    std::vector<TensorError> errors;
    for (const char* method : {"fem.p2", "sph.conforming"})
        errors.push_back({"bar_modulus_error", method, error_of([&] { return extension_error(sources.get(method).everywhere(), stress / exact); })});
    errors.push_back({"bar_modulus_error", "solver", std::abs(material::youngs_modulus(tensor.stiffness, along) / exact - 1)});
    const double confined = analytic::in_axes(plain_stiffness(tensor.stiffness), analytic::axes_about(tensor.bar))[2][2];
    errors.push_back({"bar_modulus_error", "stiffness_along", std::abs(confined / exact - 1)});
    return errors;
}

std::vector<TensorError> wave_errors(const SweepTensor& tensor) {
    const double half = std::sqrt(0.5), third = std::sqrt(1.0 / 3);
    const std::vector<Point> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {half, half, 0}, {half, 0, half}, {0, half, half}, {third, third, third}, tensor.bar};
    double solver = 0, wrong = 0;
    const auto error = [&](const Stiffness& stiffness, const Point& direction) {
        const Eigen::Vector3d speeds = material::wave_speeds(stiffness, tensor.density, eigen(direction));
        return analytic::wave_speed_error(plain_stiffness(tensor.stiffness), tensor.density, direction, plain(speeds));
    };
    for (const Point& direction : directions) {
        raise(solver, error(tensor.stiffness, direction));
        raise(wrong, error(kelvin_as_voigt(tensor.stiffness), direction));
    }
    return {{"wave_speed_error", "solver", solver}, {"wave_speed_error", "kelvin_as_voigt", wrong}};
}

std::vector<TensorError> front_errors(const SweepTensor& tensor) {
    constexpr int places = 12;
    const Penny sheared = penny_of(tensor, 1), pressed = penny_of(tensor, 0);
    double stroh = 0, tip_field = 0, swapped = 0;
    for (int place = 0; place < places; ++place) {
        const CrackAxes axes = front_axes(sheared.about, 2 * pi * (place + 0.5) / places);
        const Point k = sheared.exact.intensities(axes);
        const double exact = analytic::energy_release(plain_stiffness(tensor.stiffness), axes, k);
        raise(stroh, std::abs(by_stroh(tensor.stiffness, axes, k) / exact - 1));
        if (place % 4 == 0) raise(tip_field, std::abs(by_tip_field(tensor.stiffness, axes, k) / exact - 1));  // the slowest: 360 matrix exponentials
        raise(swapped, std::abs(by_stroh(tensor.stiffness, axes, modes_swapped(k)) / exact - 1));
    }
    const auto off = [&](double mean, const Penny& penny) { return std::abs(mean / penny.exact.mean_energy_release() - 1); };
    const double under_pressure = 4 / pi / fracture::effective_modulus(tensor.stiffness, eigen(tensor.normal));
    return {{"front_energy_release_error", "stroh", stroh},
            {"front_energy_release_error", "tip_field", tip_field},
            {"front_energy_release_error", "modes_swapped", swapped},
            {"penny_energy_release_error", "stroh", off(mean_by_stroh(tensor, sheared, as_it_is), sheared)},
            {"penny_energy_release_error", "effective_modulus", off(under_pressure, pressed)},
            {"penny_energy_release_error", "modes_swapped", off(mean_by_stroh(tensor, sheared, modes_swapped), sheared)}};
}

std::vector<TensorError> penny_errors(const SweepTensor& tensor, const SweepBodies& bodies, std::vector<SolveNote>& solves) {
    constexpr double radius = 2;  // m
    Case body = body_of(tensor, bodies, "shape = \"penny_crack_block\"\nhalf_width = \"24 m\"\ncrack_radius = \"2 m\"\ncrack_angle = \"30 deg\"\ngrading = 2.0");
    body.particles.residual_tolerance.reset();
    body.loads = {load_of(SurfaceLoad::Kind::pressure, {"crack"}), load_of(SurfaceLoad::Kind::displacement, {"left", "right", "front", "back", "bottom", "top"})};
    body.loads[0].pressure = 1e6;
    SolutionCall call = call_of("anisotropic_penny");
    call.numbers["pressure"] = 1e6;
    const double exact = make_field(call, body).scalars.at("energy_release_rate_domain");
    LevelSources sources(body, radius * bodies.penny_size, bodies.meshes);
    std::vector<TensorError> errors;
    for (const char* method : {"fem.p2", "sph.conforming"})
        errors.push_back({"penny_energy_release_error", method,
                          error_of([&] { return std::abs(sources.get(method).scalar("energy_release_rate_domain") / exact - 1); })});
    errors.push_back({"penny_energy_release_error", "without_half",
                      std::abs(sources.get("fem.p2").scalar("energy_release_rate_domain") / (2 * exact) - 1)});
    solves.insert(solves.end(), sources.notes().begin(), sources.notes().end());
    return errors;
}

}  // namespace cleave::validation
