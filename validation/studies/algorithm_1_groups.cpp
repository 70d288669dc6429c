#include "solver/fracture/radii.hpp"
#include "solver/mesh/msh_file.hpp"
#include "validation/studies/algorithm_1_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace cleave::validation {

namespace {

using fracture::CrackAnalysis;
using fracture::Criterion;
using fracture::Group;
using fracture::Grouping;
using fracture::GroupGradient;

/// One way to run Algorithm 1.
struct Way {
    std::string name;
    std::string strain_operator;
    fracture::Options options;
};

Way way(const std::string& name, Grouping grouping, int groups) {
    fracture::Options options;
    options.grouping = grouping;
    options.groups = groups;
    return {name, "corrected", options};
}

/// The default, the other rules of grouping, and from them to the printed text in two steps.
std::vector<Way> ways(int groups) {
    std::vector<Way> list{way("azimuth", Grouping::azimuth, groups), way("k_means", Grouping::k_means, groups),
                          way("distance", Grouping::distance, groups), way("members", Grouping::azimuth, groups)};
    list.back().options.group_gradient = GroupGradient::members;
    Way paper{"paper", "paper", fracture::paper_options()};
    paper.options.groups = groups;
    list.push_back(paper);
    return list;
}

CrackSpecimen specimen_of(const Algorithm1Setup& setup, mesh::TetMesh mesh, const std::string& strain_operator) {
    const std::map<int, material::Stiffness> stiffness{{mesh.regions.front(), setup.stiffness}};
    SpecimenOptions options;
    options.strain_operator = strain_operator;
    options.neighbourhood = setup.neighbourhood;
    return make_specimen(std::move(mesh), stiffness, setup.strength, setup.toughness, options);
}

mesh::TetMesh block_mesh(const Algorithm1Setup& setup, double size, const StudyContext& context) {
    return mesh::read_msh(setup.block->mesh(size, context.meshes).mesh_file);
}

CrackAnalysis run(const CrackSpecimen& specimen, const TopContact& contact, const fracture::Options& options) {
    return specimen.generator().generate(contact.analysed(), contact.displacement(specimen.particles), options);
}

double norm(const analytic::Voigt& stress) {
    double sum = 0;
    for (int i = 0; i < 6; ++i) sum += (i < 3 ? 1 : 2) * stress[i] * stress[i];
    return std::sqrt(sum);
}

analytic::Voigt difference(const material::Voigt& a, const analytic::Voigt& b) {
    analytic::Voigt result{};
    for (int i = 0; i < 6; ++i) result[i] = a[i] - b[i];
    return result;
}

analytic::Point plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Largest errors over the groups of one analysis.
struct GroupErrors {
    double stress = 0, principal = 0, direction = 0, gap = 0;
    int undefined = 0;

    /// The direction counts where the exact gap is at least 0.2.
    void add(const Group& group, const ExactGroup& exact, Criterion criterion) {
        const bool by_stress = criterion == Criterion::stress;
        const analytic::Principals& reference = by_stress ? exact.principal_stress : exact.principal_strain;
        const double scale = std::hypot(reference.value[0], reference.value[1], reference.value[2]);
        stress = std::max(stress, norm(difference(group.stress, exact.stress)) / norm(exact.stress));
        principal = std::max(principal, std::abs(group.principal.value - reference.value[0]) / scale);
        gap = std::max(gap, std::abs(group.principal.gap - reference.gap()));
        if (reference.gap() < 0.2)
            ++undefined;
        else
            direction = std::max(direction, analytic::angle_between(plain(group.principal.direction), reference.direction[0]));
    }
};

/// Of a way's answers under one load: values for checks.
class GroupRecorder {
public:
    GroupRecorder(const Way& way, const std::string& place, Resolution resolution, bool finest, StudyOutcome& outcome)
        : way_(way), place_(place), resolution_(resolution), finest_(finest), outcome_(outcome) {}

    void record(const CrackAnalysis& found, ExactField& exact, const CrackSpecimen& specimen) {
        const fracture::Brittleness& brittleness = specimen.brittleness[0];
        const bool by_stress = way_.options.criterion == Criterion::stress;
        const double threshold = by_stress ? brittleness.strength : brittleness.strain_limit;
        GroupErrors errors;
        int exact_cracks = 0;
        const auto& groups = found.points[0].groups;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            if (groups[g].members.empty()) continue;
            const ExactGroup reference = exact.group(groups[g].members, specimen.solid.stiffness[0]);
            errors.add(groups[g], reference, way_.options.criterion);
            exact_cracks += (by_stress ? reference.principal_stress : reference.principal_strain).value[0] > threshold;
            if (finest_ && by_stress) record_group(static_cast<int>(g), groups[g], reference);
        }
        record_errors(errors);
        add("cracks", way_.name, place_, static_cast<double>(found.cracks.size()));
        add("cracks", "exact " + way_.name, place_, exact_cracks);
        add("considered", way_.name, place_, found.points[0].considered);
    }

private:
    void record_errors(const GroupErrors& errors) {
        add("stress_error", way_.name, place_, errors.stress);
        add("principal_stress_error", way_.name, place_, errors.principal);
        add("direction_error", way_.name, place_, errors.direction);
        add("gap_error", way_.name, place_, errors.gap);
        add("undefined_groups", way_.name, place_, errors.undefined);
    }

    void record_group(int number, const Group& group, const ExactGroup& exact) {
        const std::string place = fmt::format("{}, group {}", place_, number + 1);
        const auto pair = [&](const char* quantity, double value, double reference) {
            add(quantity, way_.name, place, value);
            add(quantity, "exact " + way_.name, place, reference);
        };
        const analytic::Point up{0, 0, 1};
        pair("principal_stress", group.principal.value, exact.principal_stress.value[0]);
        pair("gap", group.principal.gap, exact.principal_stress.gap());
        pair("normal_tilt", analytic::angle_between(plain(group.principal.direction), up),
             analytic::angle_between(exact.principal_stress.direction[0], up));
    }

    void add(const std::string& quantity, const std::string& method, const std::string& place, double value) {
        outcome_.values.push_back({quantity, method, place, value, resolution_});
    }

    const Way& way_;
    std::string place_;
    Resolution resolution_;
    bool finest_;
    StudyOutcome& outcome_;
};

/// Members and stresses of two analyses of one body under two numberings; `order` gives the first's number for the second's.
/// Largest relative difference of a group's stress; infinity is 1, where the members differ.
double numbering_difference(const CrackAnalysis& a, const CrackAnalysis& b, const std::vector<int>& order) {
    double worst = 0;
    for (std::size_t g = 0; g < a.points[0].groups.size(); ++g) {
        const Group &one = a.points[0].groups[g], &two = b.points[0].groups[g];
        std::vector<int> members;
        for (const int i : two.members) members.push_back(order[i]);
        std::sort(members.begin(), members.end());
        if (members != one.members) return 1;
        worst = std::max(worst, (one.stress - two.stress).norm() / one.stress.norm());
    }
    return worst;
}

mesh::TetMesh renumbered(const mesh::TetMesh& mesh, std::vector<int>& order) {
    order.resize(mesh.tets.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(5));
    mesh::TetMesh other = mesh;
    for (std::size_t t = 0; t < order.size(); ++t) {
        other.tets[t] = mesh.tets[order[t]];
        other.regions[t] = mesh.regions[order[t]];
    }
    return other;
}

/// Groups cut by the particles' numbers, as a careless sort of the list would: what the twin of the numbering's check compares.
double difference_by_number(const CrackAnalysis& a, const CrackAnalysis& b, const std::vector<int>& order, int groups) {
    const auto first_of = [&](const CrackAnalysis& found) {
        std::vector<int> members;
        for (const Group& group : found.points[0].groups) members.insert(members.end(), group.members.begin(), group.members.end());
        std::sort(members.begin(), members.end());
        members.resize(members.size() / groups);
        return members;
    };
    std::vector<int> one = first_of(a), two = first_of(b);
    for (int& i : two) i = order[i];
    std::sort(two.begin(), two.end());
    return one == two ? 0 : 1;
}

void measure_numbering(const Algorithm1Setup& setup, const CrackSpecimen& specimen, const TopContact& contact, StudyOutcome& outcome) {
    std::vector<int> order;
    const CrackSpecimen other = specimen_of(setup, renumbered(specimen.mesh, order), "corrected");
    for (const Way& one : ways(setup.groups)) {
        if (one.options.group_gradient == GroupGradient::members) continue;  // the same groups
        const CrackAnalysis a = run(specimen, contact, one.options), b = run(other, contact, one.options);
        outcome.values.push_back({"numbering_difference", one.name, "", numbering_difference(a, b, order)});
        if (one.name == "azimuth")
            outcome.values.push_back({"numbering_difference", "by_number", "", difference_by_number(a, b, order, setup.groups)});
    }
}

/// What a number of groups finds: cracks beside those of the closed form, the largest principal stress, the energy of all groups.
void measure_group_count(const std::string& load, const Way& one, const CrackAnalysis& found, ExactField& exact,
                         const CrackSpecimen& specimen, StudyOutcome& outcome) {
    double largest = -1e300, exact_largest = -1e300, radius = 0;
    int exact_cracks = 0;
    for (const Group& group : found.points[0].groups) {
        if (group.members.empty()) continue;
        const double reference = exact.group(group.members, specimen.solid.stiffness[0]).principal_stress.value[0];
        largest = std::max(largest, group.principal.value);
        exact_largest = std::max(exact_largest, reference);
        exact_cracks += reference > specimen.brittleness[0].strength;
    }
    for (const fracture::Crack& crack : found.cracks) radius = std::max(radius, crack.outer_radius);
    const std::string place = fmt::format("{}, {} groups", load, one.options.groups);
    outcome.values.push_back({"principal_stress", one.name, place, largest});
    outcome.values.push_back({"principal_stress", "exact " + one.name, place, exact_largest});
    outcome.values.push_back({"cracks", one.name, place, static_cast<double>(found.cracks.size())});
    outcome.values.push_back({"cracks", "exact " + one.name, place, static_cast<double>(exact_cracks)});
    outcome.values.push_back({"outer_radius", one.name, place, radius});
}

double total_energy(const CrackAnalysis& found) {
    double sum = 0;
    for (const Group& group : found.points[0].groups) sum += group.energy;
    return sum;
}

void measure_group_counts(const Algorithm1Setup& setup, const CrackSpecimen& specimen, StudyOutcome& outcome) {
    for (const auto& [load, tangential] : loads(setup)) {
        const TopContact contact = contact_on_top(setup, setup.stiffness, middle_of_top(specimen.mesh), tangential);
        ExactField exact(contact, specimen.particles);
        double of_one = 0;
        for (const int groups : {1, 2, 4, 8, 16})
            for (const Way& one : ways(groups)) {
                if (one.options.group_gradient == GroupGradient::members) continue;
                const CrackAnalysis found = run(specimen, contact, one.options);
                measure_group_count(load, one, found, exact, specimen, outcome);
                if (groups == 1) of_one = total_energy(found);
                const std::string place = fmt::format("{}, {} groups", load, groups);
                outcome.values.push_back({"energy_over_one_group", one.name, place, total_energy(found) / of_one});
            }
    }
}

/// The load grows from one hundredth to a hundred times the force: the energy goes with its square.
void measure_inner_radius(const Algorithm1Setup& setup, const CrackSpecimen& specimen, const Eigen::Vector3d& point,
                          StudyOutcome& outcome) {
    fracture::Options options = way("k_means", Grouping::k_means, setup.groups).options;
    options.energy_limit = setup.energy_limit;
    std::array<int, 2> decreases{};
    std::array<double, 2> last{};
    for (int step = -8; step <= 8; ++step) {
        Algorithm1Setup scaled = setup;
        scaled.force *= std::pow(10, step / 4.0);
        const TopContact contact = contact_on_top(scaled, setup.stiffness, point, setup.friction * scaled.force);
        CrackSpecimen weak = specimen;
        weak.brittleness[0].strength = 0;  // the criterion is not what is looked at
        const fracture::Crack crack = run(weak, contact, options).cracks.front();
        const std::array<double, 2> now{crack.inner_radius,
                                        fracture::inner_radius(crack.energy, crack.outer_radius, setup.energy_limit, crack.outer_radius)};
        for (int k = 0; k < 2; ++k) decreases[k] += now[k] < last[k];
        last = now;
        const std::string place = fmt::format("force times {:g}", std::pow(10, step / 4.0));
        if (step % 4 == 0) outcome.values.push_back({"inner_radius", "k_means", place, now[0]});
    }
    outcome.values.push_back({"inner_radius_decreases", "k_means", "", static_cast<double>(decreases[0])});
    outcome.values.push_back({"inner_radius_decreases", "of_outer_radius", "", static_cast<double>(decreases[1])});
}

}  // namespace

TopContact contact_on_top(const Algorithm1Setup& setup, const material::Stiffness& stiffness, const Eigen::Vector3d& point,
                          double tangential) {
    return TopContact(stiffness, point, {tangential, 0, -setup.force}, setup.contact_radius);
}

std::vector<std::pair<std::string, double>> loads(const Algorithm1Setup& setup) {
    return {{"normal load", 0}, {"oblique load", setup.friction * setup.force}};
}

Eigen::Vector3d middle_of_top(const mesh::TetMesh& mesh) {
    Eigen::Vector3d low = mesh.vertices.front(), high = low;
    for (const Eigen::Vector3d& x : mesh.vertices) low = low.cwiseMin(x), high = high.cwiseMax(x);
    return {0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), high.z()};
}

void measure_groups(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome) {
    for (const double size : setup.sizes) {
        const mesh::TetMesh mesh = block_mesh(setup, size, context);
        const CrackSpecimen corrected = specimen_of(setup, mesh, "corrected"), paper = specimen_of(setup, mesh, "paper");
        const Resolution resolution{size, corrected.particles.size(), 0};
        for (const auto& [load, tangential] : loads(setup)) {
            const TopContact contact = contact_on_top(setup, setup.stiffness, middle_of_top(mesh), tangential);
            ExactField exact(contact, corrected.particles);
            for (const Way& one : ways(setup.groups)) {
                const CrackSpecimen& specimen = one.strain_operator == "paper" ? paper : corrected;
                const CrackAnalysis found = run(specimen, contact, one.options);
                GroupRecorder(one, load, resolution, size == setup.sizes.back(), outcome).record(found, exact, specimen);
            }
        }
    }
}

void measure_invariance(const Algorithm1Setup& setup, const StudyContext& context, StudyOutcome& outcome) {
    const CrackSpecimen specimen = specimen_of(setup, block_mesh(setup, setup.sizes.front(), context), "corrected");
    const Eigen::Vector3d point = middle_of_top(specimen.mesh);
    const TopContact contact = contact_on_top(setup, setup.stiffness, point, setup.friction * setup.force);
    measure_numbering(setup, specimen, contact, outcome);
    measure_group_counts(setup, specimen, outcome);
    measure_inner_radius(setup, specimen, point, outcome);
}

}  // namespace cleave::validation
