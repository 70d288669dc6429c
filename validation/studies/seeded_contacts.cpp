#include "validation/studies/seeded_contacts.hpp"

#include "solver/simulation/scene_body.hpp"
#include "validation/studies/sample_statistics.hpp"
#include "validation/studies/scene_claims.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace cleave::validation {

namespace {

using Eigen::Vector3d;
using simulation::SceneBody;

struct Variant {
    std::string name;
    simulation::Overrides set;
};

/// A triangle of the body's surface.
struct Place {
    Vector3d centre, inward;
    double area = 0;
};

/// What one contact did.
struct Answer {
    int cracks = 0, fragments = 1;
    double angle = 0;                                ///< rad, mean between crack normals and the surface's normal; of contacts with cracks
    std::map<std::string, Eigen::Vector2d> axes;     ///< by material: mean vector of the doubled angles of its cracks' traces in the x-y plane, by length
};

Place place_of(const mesh::TetMesh& mesh, int half_face) {
    const auto [a, b, c] = mesh::face_of(mesh.tets[static_cast<std::size_t>(half_face / 4)], half_face % 4);
    const Vector3d &x = mesh.vertices[static_cast<std::size_t>(a)], &y = mesh.vertices[static_cast<std::size_t>(b)], &z = mesh.vertices[static_cast<std::size_t>(c)];
    const Vector3d centre = (x + y + z) / 3, normal = (y - x).cross(z - x);
    const bool outwards = normal.dot(centre - mesh::tet_centroid(mesh, half_face / 4)) > 0;
    return {centre, (outwards ? -normal : normal).normalized(), 0.5 * normal.norm()};
}

/// Whether a tet of another region has its centroid within `reach`.
bool near_interface(const mesh::TetMesh& mesh, int tet, const Vector3d& centre, double reach) {
    for (int other = 0; other < static_cast<int>(mesh.tets.size()); ++other)
        if (mesh.regions[static_cast<std::size_t>(other)] != mesh.regions[static_cast<std::size_t>(tet)] &&
            (mesh::tet_centroid(mesh, other) - centre).norm() <= reach)
            return true;
    return false;
}

/// A uniform number in [0, 1), the same with every library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

class SeededContacts final : public Study {
public:
    std::string scene;
    std::vector<Variant> variants;
    int quick_contacts = 20, full_contacts = 20;
    std::uint64_t seed = 1;
    double speed = 0, mass = 0, radius = 0;  ///< m/s, kg, m: Hertz's impact of a rigid striker
    bool open = true;                        ///< false: cracks are found and not opened, so fragments are not counted
    double interface_reach = 0;              ///< m; 0: anywhere on the surface. Else on faces that look up, so near another material

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        for (const std::string method : {"corrected", "paper"}) {
            std::vector<std::vector<Answer>> answers;
            for (const Variant& variant : variants) {
                answers.push_back(answers_of(variant, method, context));
                add_means(answers.back(), variant.name, method, outcome);
                add_changes(answers.front(), answers.back(), variant.name, method, outcome);
                add_directions(answers.back(), variant.name, method, outcome);
            }
        }
        return outcome;
    }

private:
    std::vector<Place> places(const SceneBody& body, int count) const {
        const mesh::TetMesh& mesh = body.fragmented().original();
        const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
        std::vector<Place> faces;
        std::vector<double> sum{0};
        for (int half_face = 0; half_face < static_cast<int>(links.opposite.size()); ++half_face) {
            if (links.opposite[static_cast<std::size_t>(half_face)] >= 0) continue;
            const Place place = place_of(mesh, half_face);
            if (interface_reach > 0 && (place.inward.z() > -0.9 || !near_interface(mesh, half_face / 4, place.centre, interface_reach))) continue;
            faces.push_back(place);
            sum.push_back(sum.back() + place.area);
        }
        std::mt19937_64 random(seed);
        std::vector<Place> chosen;
        for (int i = 0; i < count && !faces.empty(); ++i) {
            const auto at = std::upper_bound(sum.begin() + 1, sum.end() - 1, uniform(random) * sum.back());
            chosen.push_back(faces[static_cast<std::size_t>(at - sum.begin()) - 1]);
        }
        return chosen;
    }

    std::vector<Answer> answers_of(const Variant& variant, const std::string& method, const StudyContext& context) const {
        simulation::Overrides set = variant.set;
        set.emplace_back("analysis.strain_operator", '"' + method + '"');
        const simulation::Scene of = simulation::find_scene(scene, set);
        SceneBody body(of.bodies.front(), of, context.meshes);
        std::vector<Answer> answers;
        for (const Place& place : places(body, context.level == "quick" ? quick_contacts : full_contacts)) answers.push_back(hit(body, place));
        return answers;
    }

    Answer hit(SceneBody& body, const Place& place) const {
        body.make_whole();
        const contact::ContactLoad load = body.peak_load({.point = place.centre, .inward = place.inward, .effective_mass = mass, .curvature = 1 / radius,
                                                          .other_modulus = std::numeric_limits<double>::infinity(), .speed = speed});
        const fracture::CrackAnalysis found = body.analyse(load);
        Answer answer;
        std::map<std::string, double> lengths;
        for (const fracture::Crack& crack : found.cracks) {
            ++answer.cracks;
            answer.angle += std::acos(std::min(1.0, std::abs(crack.normal.dot(place.inward)))) / static_cast<double>(found.cracks.size());
            if (std::hypot(crack.normal.x(), crack.normal.y()) < 1e-6) continue;  // a crack across z has no trace
            const std::string material = body.material_name(crack.material);
            lengths[material] += crack.outer_radius;
            answer.axes.try_emplace(material, 0, 0).first->second += crack.outer_radius * doubled(-crack.normal.y(), crack.normal.x());
        }
        for (auto& [material, vector] : answer.axes) vector /= lengths[material];
        if (!open) return answer;
        simulation::CrackTimes times;
        answer.fragments = static_cast<int>(body.open_cracks(found.cracks, 0, times).fragments.size());
        return answer;
    }

    void add_means(const std::vector<Answer>& answers, const std::string& variant, const std::string& method, StudyOutcome& outcome) const {
        std::vector<double> angles, fragments, cracks;
        for (const Answer& answer : answers) {
            if (answer.cracks > 0) angles.push_back(answer.angle);
            fragments.push_back(answer.fragments);
            cracks.push_back(answer.cracks);
        }
        outcome.values.push_back({"surface_angle", method, variant, estimate(angles).mean});
        if (open) outcome.values.push_back({"fragments", method, variant, estimate(fragments).mean});
        outcome.values.push_back({"cracks", method, variant, estimate(cracks).mean});
    }

    /// Pairs by place; angles where both cracked.
    static void add_changes(const std::vector<Answer>& first, const std::vector<Answer>& other, const std::string& variant, const std::string& method,
                            StudyOutcome& outcome) {
        std::vector<double> angles, fragments;
        for (std::size_t i = 0; i < first.size(); ++i) {
            if (first[i].cracks > 0 && other[i].cracks > 0) angles.push_back(other[i].angle - first[i].angle);
            fragments.push_back(other[i].fragments - first[i].fragments);
        }
        for (const auto& [quantity, change] : {std::pair{"surface_angle", estimate(angles)}, std::pair{"fragments", estimate(fragments)}}) {
            outcome.values.push_back({fmt::format("{}_change", quantity), method, variant, change.mean});
            outcome.values.push_back({fmt::format("{}_interval", quantity), method, variant, change.interval});
            outcome.values.push_back({fmt::format("{}_changes", quantity), method, variant, std::abs(change.mean) > change.interval ? 1.0 : 0.0});
        }
    }

    /// Of bodies of two materials; contacts that cracked both count.
    static void add_directions(const std::vector<Answer>& answers, const std::string& variant, const std::string& method, StudyOutcome& outcome) {
        std::map<std::string, std::vector<Eigen::Vector2d>> axes;
        for (const Answer& answer : answers)
            if (answer.axes.size() == 2)
                for (const auto& [material, vector] : answer.axes) axes[material].push_back(vector);
        if (axes.size() != 2) return;
        std::vector<AxialEstimate> sides;
        for (const auto& [material, vectors] : axes) {
            const AxialEstimate& side = sides.emplace_back(axial_estimate(vectors));
            const std::string place = fmt::format("{}, {}", variant, material);
            outcome.values.push_back({"direction", method, place, side.mean});
            outcome.values.push_back({"direction_spread", method, place, side.spread});
        }
        const double turned = std::abs(std::remainder(sides[0].mean - sides[1].mean, std::numbers::pi));
        const double interval = std::min(std::hypot(sides[0].interval, sides[1].interval), std::numbers::pi / 2);  // all axes
        outcome.values.push_back({"both_cracked", method, variant, static_cast<double>(axes.begin()->second.size())});
        outcome.values.push_back({"direction_difference", method, variant, turned});
        outcome.values.push_back({"direction_interval", method, variant, interval});
        outcome.values.push_back({"directions_differ", method, variant, turned > interval ? 1.0 : 0.0});
    }
};

std::vector<QuantityInfo> quantities() {
    std::vector<QuantityInfo> list;
    for (const char* name : {"fragments", "fragments_change", "fragments_interval", "fragments_changes", "surface_angle_changes", "cracks",
                             "both_cracked", "directions_differ"})
        list.push_back({name, dimension::none});
    for (const char* name : {"surface_angle", "surface_angle_change", "surface_angle_interval", "direction", "direction_spread",
                             "direction_difference", "direction_interval"})
        list.push_back({name, dimension::none, true});
    return list;
}

int contacts(TableReader& table, const std::string& key) {
    const long value = table.integer(key);
    if (value < 2 || value > 10'000) table.fail(key, "an integer from 2 to 10000");
    return static_cast<int>(value);
}

double positive(TableReader& table, const std::string& key, Dimension unit) {
    const double value = table.quantity(key, unit);
    if (!(value > 0)) table.fail(key, "a value above zero");
    return value;
}

std::shared_ptr<const Study> read(TableReader& table) {
    auto study = std::make_shared<SeededContacts>();
    study->scene = table.choice("scene", simulation::scene_names());
    study->quick_contacts = contacts(table, "quick_contacts");
    study->full_contacts = contacts(table, "full_contacts");
    study->seed = static_cast<std::uint64_t>(table.integer("seed"));
    study->speed = positive(table, "speed", dimension::velocity);
    study->mass = positive(table, "effective_mass", dimension::mass);
    study->open = table.boolean_or("open", true);
    study->radius = positive(table, "contact_radius", dimension::length);
    if (table.has("near_interface")) study->interface_reach = positive(table, "near_interface", dimension::length);
    for (TableReader& variant : table.tables("variants"))
        study->variants.push_back({variant.string("name"), variant.has("set") ? read_overrides(variant, "set") : simulation::Overrides{}});
    return study;
}

}  // namespace

StudyInfo seeded_contacts_study() {
    return {"seeded_contacts", "contacts at seeded places of a scene's body: what kernels and materials change",
            {"scene", "quick_contacts", "full_contacts", "seed", "speed", "effective_mass", "contact_radius", "near_interface", "open", "variants"},
            quantities(), {"corrected", "paper"}, read};
}

}  // namespace cleave::validation
