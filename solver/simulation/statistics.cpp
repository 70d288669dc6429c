#include "solver/simulation/statistics.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace cleave::simulation {
namespace {

using Json = nlohmann::ordered_json;

// Tables 1 and 2. Pot1 is the left, Pot2 the right of Fig. 7; Table 2 has one line for a pot and one for glass.
constexpr std::array<PaperRow, 7> paper{{
    {"pot_basic", "Pot1", 6163, 6163, 1081, 6, 0, 0, 0, 0},
    {"pot_adaptive", "Pot2", 6163, 15717, 1081, 14, 86, 2869, 1505, 10.2},
    {"glass_small_ball", "Glass1", 1743, 9027, 314, 436, 91, 1593, 329, 36.8},
    {"glass_large_ball", "Glass2", 1743, 9027, 314, 598, 91, 1593, 329, 36.8},
    {"pots", "Pots", 80119, 144975, 14053, 587, 588, 12923, 11037, 1.3},
    {"pet", "Pet", 23664, 57882, 3678, 47, 341, 86784, 3386, 1.2},
    {"tai_chi", "Tai Chi", 3880, 27278, 611, 87, 649, 12330, 4010, 7.6},
}};

double crack_area(const Shape& shape) {
    const auto point = [&](std::uint32_t i) {
        const auto& p = shape.points[i];
        return Eigen::Vector3d(p[0], p[1], p[2]);
    };
    double area = 0;
    for (const auto& [a, b, c] : shape.crack) area += 0.5 * (point(b) - point(a)).cross(point(c) - point(a)).norm();
    return area;
}

const Shape& shape_of_piece(const Simulation& simulation, const Piece& piece) {
    return piece.track >= 0 ? simulation.state().tracks[piece.track].shape : piece.shape;
}

Json vector_json(const Eigen::Vector3d& v) { return Json::array({v[0], v[1], v[2]}); }

Json impacts_json(const Simulation& simulation) {
    Json list = Json::array();
    for (const ImpactRecord& impact : simulation.state().impacts) {
        Json normals = Json::array();
        for (const Eigen::Vector3d& normal : impact.normals) normals.push_back(vector_json(normal));
        list.push_back({{"frame", impact.frame},
                        {"body", simulation.scene().bodies[impact.body].name},
                        {"fragment", impact.fragment},
                        {"speed", impact.speed},
                        {"effective_mass", impact.effective_mass},
                        {"peak_force", impact.force},
                        {"contact_radius", impact.contact_radius},
                        {"point", vector_json(impact.point)},
                        {"inward", vector_json(impact.inward)},
                        {"principals", impact.principals},
                        {"crack_normals", normals},
                        {"outer_radii", impact.outer_radii},
                        {"inner_radii", impact.inner_radii},
                        {"pieces", impact.fragments}});
    }
    return list;
}

Json paper_json(const std::string& scene) {
    const PaperRow* row = paper_row(scene);
    if (!row) return nullptr;
    return {{"row", row->row}, {"physical", row->physical}, {"subdivided", row->subdivided}, {"boundary", row->boundary}, {"fragments", row->fragments}};
}

/// Per body that can break: particles whose support was enlarged, that no support satisfied, where a lower operator stands in.
Json operators_json(const Simulation& simulation) {
    Json list = Json::array();
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i) {
        const elasticity::OperatorReport* report = simulation.bodies()[i]->operator_report();
        if (!report) continue;
        list.push_back({{"body", simulation.scene().bodies[i].name},
                        {"operator", simulation.scene().strain_operator},
                        {"particles", report->particles},
                        {"raised_supports", report->raised_supports},
                        {"poor_supports", report->poor_supports},
                        {"fallbacks", report->fallbacks}});
    }
    return list;
}

/// The same as a line per body.
std::string operators_text(const Simulation& simulation) {
    std::string text;
    for (const Json& entry : operators_json(simulation)) {
        text += fmt::format("  {}, strain operator {}: {} supports enlarged, {} still poor, {} fallbacks\n", entry["body"].get<std::string>(),
                            entry["operator"].get<std::string>(), entry["raised_supports"].get<int>(), entry["poor_supports"].get<int>(),
                            entry["fallbacks"].get<int>());
    }
    return text;
}

double per_event(double seconds, int events) { return events > 0 ? 1e3 * seconds / events : 0; }

}  // namespace

const PaperRow* paper_row(const std::string& scene) {
    const auto found = std::find_if(paper.begin(), paper.end(), [&](const PaperRow& row) { return row.scene == scene; });
    return found == paper.end() ? nullptr : &*found;
}

Counts count(const Simulation& simulation) {
    Counts counts;
    for (const auto& body : simulation.bodies()) {
        counts.physical += body->original_particles();
        counts.subdivided += body->particles_now();
    }
    double heaviest = 0;
    for (const Piece& piece : simulation.pieces()) {
        if (piece.rigid >= 0) counts.boundary_now += piece.boundary_particles;
        if (simulation.bodies()[piece.body]->is_ball()) continue;
        ++counts.fragments;
        counts.mass += piece.mass.mass;
        counts.crack_area += crack_area(shape_of_piece(simulation, piece));
        heaviest = std::max(heaviest, piece.mass.mass);
        if (piece.rigid >= 0) continue;
        ++counts.debris;
        counts.debris_mass += piece.mass.mass;
    }
    counts.boundary = simulation.state().watch.boundary_at_start;
    counts.largest_share = counts.mass > 0 ? heaviest / counts.mass : 0;
    return counts;
}

std::string statistics_json(const Simulation& simulation) {
    const Counts counts = count(simulation);
    const Watch& watch = simulation.state().watch;
    const Json json{
        {"schema", "cleave.statistics/1"},
        {"scene", simulation.scene().name},
        {"frames", simulation.frame()},
        {"steps", watch.steps},
        {"free_steps_of_pieces", watch.free_steps},
        {"physical_particles", counts.physical},
        {"subdivided_particles", counts.subdivided},
        {"boundary_particles", counts.boundary},
        {"boundary_particles_at_end", counts.boundary_now},
        {"fragments", counts.fragments},
        {"debris", {{"count", counts.debris}, {"mass", counts.debris_mass}, {"below", simulation.scene().debris_below}}},
        {"mass", counts.mass},
        {"largest_fragment_share", counts.largest_share},
        {"crack_area", counts.crack_area},
        {"contacts_analysed", simulation.state().impacts.size()},
        {"fractures", watch.fractures},
        {"mass_error", watch.mass_error},
        {"momentum_error", watch.momentum_error},
        {"angular_momentum_error", watch.angular_momentum_error},
        {"energy_growth_without_contact", watch.energy_growth},
        {"largest_kinetic_energy", watch.energy_scale},
        {"deepest_penetration", watch.penetration},
        {"strain_operators", operators_json(simulation)},
        {"paper", paper_json(simulation.scene().name)},
        {"impacts", impacts_json(simulation)},
    };
    return json.dump(2) + "\n";
}

std::string timings_json(const Simulation& simulation, const RunTimes& times) {
    const Clock& clock = simulation.clock();
    const auto entry = [&](double seconds) { return Json{{"total_s", seconds}, {"per_fracture_ms", per_event(seconds, clock.fractures)}}; };
    const PaperRow* row = paper_row(simulation.scene().name);
    Json json{
        {"schema", "cleave.timings/1"},
        {"scene", simulation.scene().name},
        {"threads", times.threads},
        {"frames", times.frames},
        {"fractures", clock.fractures},
        {"set_up_s", times.set_up},
        {"simulated_s", times.simulated},
        {"processor_s", times.processor},
        {"output_s", times.output},
        {"frame_rate", times.simulated > 0 ? times.frames / times.simulated : 0},
        {"frame_rate_of_processor", times.processor > 0 ? times.frames / times.processor : 0},
        {"dynamics_s", clock.dynamics},
        {"stress_analysis", entry(clock.analysis)},
        {"subdivision", entry(clock.subdivision)},
        {"crack_generation", entry(clock.cracks)},
        {"new_bodies", entry(clock.fragments)},
    };
    json["paper"] = row && row->frame_rate > 0 ? Json{{"row", row->row},
                                                      {"stress_analysis_ms", row->analysis},
                                                      {"particle_subdivision_ms", row->subdivision},
                                                      {"crack_generation_ms", row->cracks},
                                                      {"frame_rate", row->frame_rate}}
                                               : Json(nullptr);
    return json.dump(2) + "\n";
}

std::string summary_text(const Simulation& simulation, const RunTimes& times) {
    const Counts counts = count(simulation);
    const Clock& clock = simulation.clock();
    const PaperRow* row = paper_row(simulation.scene().name);
    const auto beside = [&](int value) { return row ? fmt::format("{:>8}", value) : std::string("       -"); };
    const auto rate = times.simulated > 0 ? times.frames / times.simulated : 0.0;
    std::string text = fmt::format("{}, {} frames\n{:26}{:>10}{:>10}\n", simulation.scene().name, simulation.frame(), "", "ours", row ? row->row : "paper");
    text += fmt::format("  physical particles      {:>10}  {}\n", counts.physical, beside(row ? row->physical : 0));
    text += fmt::format("  subdivided particles    {:>10}  {}\n", counts.subdivided, beside(row ? row->subdivided : 0));
    text += fmt::format("  boundary particles      {:>10}  {}\n", counts.boundary, beside(row ? row->boundary : 0));
    text += fmt::format("  fragments               {:>10}  {}\n", counts.fragments, beside(row ? row->fragments : 0));
    text += fmt::format("  debris among them       {:>10}            {:.3g} kg of {:.3g} kg\n", counts.debris, counts.debris_mass, counts.mass);
    text += fmt::format("  frame rate              {:>10.1f}  {:>8}\n", rate, row && row->frame_rate > 0 ? fmt::format("{}", row->frame_rate) : "-");
    text += fmt::format("  fractures {}: ms in total: stress analysis {:.3g}, subdivision {:.3g}, cracks {:.3g}, new bodies {:.3g}\n", clock.fractures,
                        1e3 * clock.analysis, 1e3 * clock.subdivision, 1e3 * clock.cracks, 1e3 * clock.fragments);
    text += operators_text(simulation);
    if (row && row->frame_rate > 0)
        text += fmt::format("  the paper's (2010 Xeon):      stress analysis {}, subdivision {}, cracks {}\n", row->analysis, row->subdivision, row->cracks);
    return text;
}

}  // namespace cleave::simulation
