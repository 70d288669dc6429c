#include "validation/adapters/fem_crack.hpp"

#include "reference_fem/crack_direction.hpp"
#include "reference_fem/kinked_crack.hpp"
#include "solver/mesh/msh_file.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace cleave::validation {

namespace {

/// The mesh with its vertices moved by `distance` times the growth, as a file of its own beside the mesh; removed again.
class MovedMesh {
public:
    MovedMesh(const geometry::Body& body, const std::function<Point(const Point&)>& growth, double distance) : body_(body) {
        mesh::TetMesh mesh = mesh::read_msh(body.mesh_file);
        for (Eigen::Vector3d& x : mesh.vertices) {
            const Point q = growth({x[0], x[1], x[2]});
            x += distance * Eigen::Vector3d(q[0], q[1], q[2]);
        }
        body_.mesh_file += fmt::format(".moved{}.msh", ::getpid());
        mesh::write_msh(mesh, body_.mesh_file);
    }
    ~MovedMesh() {
        std::error_code ignored;
        std::filesystem::remove(body_.mesh_file, ignored);
    }
    MovedMesh(const MovedMesh&) = delete;
    MovedMesh& operator=(const MovedMesh&) = delete;
    const geometry::Body& body() const { return body_; }

private:
    geometry::Body body_;
};

fem::CrackFront plain(const geometry::CrackFront& front) {
    const auto locate = [front](const fem::Point& x) {
        const geometry::FrontPlace place = front.locate(x);
        return fem::FrontPlace{place.axes, place.ahead, place.above, place.along};
    };
    return {locate, front.point_at, front.length, front.loop};
}

}  // namespace

FemCrack::FemCrack(const Case& of, const geometry::Body& body, const MakeProblem& make_problem, const fem::Solution& solution,
                   const fem::Options& options)
    : of_(of), body_(body), make_problem_(make_problem), solution_(solution), options_(options), problem_(make_problem(body)) {}

fem::CrackGrowth FemCrack::growth(const fem::Problem& problem, const std::function<Point(const Point&)>& field) const {
    return {problem, solution_, field, body_.surfaces.at(of_.shape->crack_fronts().front().lips)};
}

double FemCrack::energy_release_rate() const {
    const auto field = whole_growth(*of_.shape);
    const double step = 1e-3 * of_.shape->crack_fronts().front().reach;
    const auto potential_at = [&](double distance) {
        const MovedMesh moved(body_, field, distance);
        const fem::Problem problem = make_problem_(moved.body());
        return fem::potential_energy(problem, fem::solve(problem, options_));
    };
    return (potential_at(-step) - potential_at(step)) / (2 * step * fem::crack_width(growth(problem_, field)));
}

double FemCrack::energy_release_rate_domain() const { return fem::energy_release_by_domain(growth(problem_, whole_growth(*of_.shape))); }

const FemCrack::Station& FemCrack::station(const Point& place) const {
    const auto found = stations_.find(place);
    if (found != stations_.end()) return found->second;
    Station result{station_near(*of_.shape, place), 0, {}, 0};
    const fem::CrackGrowth crack = growth(problem_, result.station.growth);
    result.domain = fem::energy_release_by_domain(crack);
    const fem::AuxiliaryField auxiliary(solution_.material(0), plain(result.station.front));
    const fem::FrontIntensities front = fem::intensities_by_interaction(crack, auxiliary, result.station.place.position);
    result.k = front.k;
    result.from_k = front.energy_release;
    return stations_.emplace(place, result).first->second;
}

double FemCrack::direction(const Station& at, const std::string& criterion) const {
    const fem::Stiffness stiffness = fem::in_axes(solution_.material(0), at.station.place.axes);
    if (criterion == "energy") return fem::energy_kink_angle(stiffness, at.k);
    if (criterion == "hoop") return fem::kink_angle(stiffness, at.k, [](double) { return 1.0; });
    return fem::kink_angle(stiffness, at.k, [&](double angle) { return relative_toughness(of_.toughness, at.station, angle); });
}

double FemCrack::at_front(const std::string& quantity, const std::string& component, const Point& place) const {
    const Station& at = station(place);
    if (quantity == "energy_release_rate_at") return at.domain;
    if (quantity == "energy_release_rate_from_k") return at.from_k;
    if (quantity == "energy_release_gap") return std::abs(at.from_k / at.domain - 1);
    if (quantity == "crack_direction") return component == "hoop_size" ? std::abs(direction(at, "hoop")) : direction(at, component);
    if (quantity == "stress_intensity") return at.k[component == "II" ? 0 : component == "I" ? 1 : 2];
    throw std::invalid_argument("a quantity of the front that finite elements have");
}

}  // namespace cleave::validation
