#include "solver/mesh/msh_file.hpp"
#include "validation/studies/algorithm_1_parts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cleave::validation {

namespace {

using fracture::Crack;
using fracture::CrackAnalysis;

analytic::Point plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

double relative_error(const material::Voigt& stress, const analytic::Voigt& exact) {
    double error = 0, scale = 0;
    for (int i = 0; i < 6; ++i) {
        error += (i < 3 ? 1 : 2) * std::pow(stress[i] - exact[i], 2);
        scale += (i < 3 ? 1 : 2) * exact[i] * exact[i];
    }
    return std::sqrt(error / scale);
}

/// What the cracks beyond the interface are compared with.
struct BeyondInterface {
    double stress_error = 0, direction_error = 0, turn = 0, exact_turn = 0;
    int cracks = 0, exact_cracks = 0;
};

BeyondInterface beyond_interface(const CrackAnalysis& found, const CrackSpecimen& specimen, ExactField& exact) {
    BeyondInterface result;
    for (std::size_t p = 1; p < found.points.size(); ++p)
        for (const fracture::Group& group : found.points[p].groups) {
            if (group.members.empty()) continue;
            const ExactGroup reference = exact.group(group.members, specimen.solid.stiffness[found.points[p].material]);
            result.exact_cracks += reference.principal_stress.value[0] > specimen.brittleness[0].strength;
            result.cracks += group.cracked;
            result.stress_error = std::max(result.stress_error, relative_error(group.stress, reference.stress));
            if (reference.principal_stress.gap() < 0.2) continue;
            const double angle = analytic::angle_between(plain(group.principal.direction), reference.principal_stress.direction[0]);
            result.direction_error = std::max(result.direction_error, angle);
        }
    for (const Crack& crack : found.cracks) {
        if (crack.parent < 0) continue;
        const Crack& parent = found.cracks[crack.parent];
        const auto exact_normal = [&](const Crack& one) {
            return exact.group(one.members, specimen.solid.stiffness[one.material]).principal_stress.direction[0];
        };
        const double turn = analytic::angle_between(plain(crack.normal), plain(parent.normal));
        if (turn < result.turn) continue;
        result.turn = turn;
        result.exact_turn = analytic::angle_between(exact_normal(crack), exact_normal(parent));
    }
    return result;
}

/// A plate's kernels by name: factors of the half axes along the surface and along its normal.
struct Stretch {
    const char* name;
    double along, normal;
};

/// The paper's invincible surface "enlarges the minimal eigenvalue and diminishes the other two": the normal's. In the covariance of WPCA,
/// where it is minimal, that lengthens the kernel along the normal; in the smoothing tensor G it shortens it. Then Fig. 8's two.
constexpr std::array stretches{Stretch{"plain", 1, 1}, Stretch{"eigenvalues of G", 1.6, 0.5},
                               Stretch{"eigenvalues of the covariance", 0.6, 2}, Stretch{"along the surface 1/5", 0.2, 1},
                               Stretch{"along the surface 3", 3, 1}};

CrackSpecimen plate_specimen(const Algorithm1Setup& setup, const mesh::TetMesh& mesh, const Stretch& stretch) {
    particles::WpcaOptions wpca;
    wpca.scale = {stretch.along, stretch.along, stretch.normal};
    SpecimenOptions options;
    options.wpca = &wpca;
    return make_specimen(mesh, {{mesh.regions.front(), setup.stiffness}}, setup.strength, setup.toughness, options);
}

/// Cracks of many contacts on a plate, and how many of them stand on the surface, their planes steeper than 45 degrees.
struct Breaking {
    int contacts = 0, cracks = 0, breaking = 0;
    double considered = 0;
};

/// A grid of contacts over the middle third of the plate, each under a normal load and two oblique ones.
Breaking break_plate(const Algorithm1Setup& setup, const CrackSpecimen& specimen) {
    const Eigen::Vector3d middle = middle_of_top(specimen.mesh);
    const double step = middle.x() / 6;
    fracture::CrackGenerator generator = specimen.generator();
    fracture::Options options;
    options.grouping = fracture::Grouping::k_means;
    options.groups = setup.plate_groups;
    Algorithm1Setup on_plate = setup;
    on_plate.contact_radius = setup.plate_contact_radius;
    Breaking result;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (const double tangential : {0.0, setup.friction * setup.force, -setup.friction * setup.force}) {
                const Eigen::Vector3d point = middle + step * Eigen::Vector3d(i, j, 0);
                const TopContact contact = contact_on_top(on_plate, setup.stiffness, point, tangential);
                const CrackAnalysis found = generator.generate(contact.analysed(), contact.displacement(specimen.particles), options);
                ++result.contacts;
                result.considered += found.points[0].considered;
                result.cracks += static_cast<int>(found.cracks.size());
                for (const Crack& crack : found.cracks) result.breaking += std::abs(crack.normal.z()) < std::sqrt(0.5);
            }
    return result;
}

}  // namespace

void measure_interface(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome) {
    const geometry::Body body = setup.laminate->mesh(setup.laminate_size, context.meshes);
    const mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
    SpecimenOptions specimen_options;
    specimen_options.neighbourhood = setup.neighbourhood;
    const std::map<int, material::Stiffness> stiffness{{body.regions.at("lower"), setup.second},
                                                       {body.regions.at("upper"), setup.stiffness}};
    const CrackSpecimen specimen = make_specimen(mesh, stiffness, setup.strength, setup.toughness, specimen_options);
    const TopContact contact = contact_on_top(setup, setup.stiffness, middle_of_top(mesh), setup.friction * setup.force);
    ExactField exact(contact, specimen.particles);
    fracture::Options options;
    options.grouping = fracture::Grouping::azimuth;  // standing cracks, which reach down to the interface
    options.groups = setup.groups;
    const CrackAnalysis found = specimen.generator().generate(contact.analysed(), contact.displacement(specimen.particles), options);
    const BeyondInterface beyond = beyond_interface(found, specimen, exact);
    const std::string place = "second material";
    const Resolution resolution{setup.laminate_size, specimen.particles.size(), 0};
    const auto add = [&](const char* quantity, const char* method, double value) {
        outcome.values.push_back({quantity, method, place, value, resolution});
    };
    add("critical_points", "azimuth", static_cast<double>(found.critical.size()));
    for (const fracture::CriticalPoint& critical : found.critical) add("critical_point_height", "azimuth", critical.position.z());
    add("cracks", "azimuth", beyond.cracks);
    add("cracks", "exact azimuth", beyond.exact_cracks);
    add("stress_error", "azimuth", beyond.stress_error);
    add("direction_error", "azimuth", beyond.direction_error);
    add("turn_at_interface", "azimuth", beyond.turn);
    add("turn_at_interface", "exact azimuth", beyond.exact_turn);
}

void measure_kernel_axes(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome) {
    const mesh::TetMesh mesh = mesh::read_msh(setup.plate->mesh(setup.plate_size, context.meshes).mesh_file);
    const Resolution resolution{setup.plate_size, static_cast<long>(mesh.tets.size()), 0};
    const auto add = [&](const char* quantity, const std::string& place, double value) {
        outcome.values.push_back({quantity, "k_means", place, value, resolution});
    };
    double plain_count = 0;
    for (const Stretch& stretch : stretches) {
        const Breaking result = break_plate(setup, plate_specimen(setup, mesh, stretch));
        const double per_contact = static_cast<double>(result.breaking) / result.contacts;
        if (&stretch == &stretches.front()) plain_count = per_contact;
        add("considered", stretch.name, result.considered / result.contacts);
        add("cracks", stretch.name, static_cast<double>(result.cracks) / result.contacts);
        add("breaking_cracks", stretch.name, per_contact);
        add("breaking_share", stretch.name, result.cracks > 0 ? static_cast<double>(result.breaking) / result.cracks : 0);
        add("breaking_ratio", stretch.name, per_contact / plain_count);
    }
}

}  // namespace cleave::validation
