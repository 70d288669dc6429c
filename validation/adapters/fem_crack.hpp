#pragma once

#include "reference_fem/crack_integrals.hpp"
#include "reference_fem/elasticity.hpp"
#include "validation/adapters/crack_station.hpp"

#include <map>

namespace cleave::validation {

/// Energy release rates, stress intensities and crack directions of a finite element solution. Everything is computed when first asked for.
class FemCrack {
public:
    using MakeProblem = std::function<fem::Problem(const geometry::Body&)>;

    FemCrack(const Case& of, const geometry::Body& body, const MakeProblem& make_problem, const fem::Solution& solution, const fem::Options& options);

    /// G = -dPi/dA (Irwin 1956), Pi the potential energy of body and loads, by a central difference of two solves on moved vertices: no
    /// re-meshing, so the mesh's own error cancels. J/m^2, all fronts growing alike.
    double energy_release_rate() const;
    /// The same by the domain integral.
    double energy_release_rate_domain() const;
    /// A quantity of the front (is_front_quantity), SI. Throws std::invalid_argument.
    double at_front(const std::string& quantity, const std::string& component, const Point& place) const;

private:
    struct Station {
        CrackStation station;
        double domain = 0;  ///< G by the domain integral
        fem::Intensities k{};
        double from_k = 0;
    };
    fem::CrackGrowth growth(const fem::Problem& problem, const std::function<Point(const Point&)>& field) const;
    const Station& station(const Point& place) const;
    double direction(const Station& at, const std::string& criterion) const;

    const Case& of_;
    geometry::Body body_;
    MakeProblem make_problem_;
    fem::Solution solution_;
    fem::Options options_;
    fem::Problem problem_;
    mutable std::map<Point, Station> stations_;
};

}  // namespace cleave::validation
