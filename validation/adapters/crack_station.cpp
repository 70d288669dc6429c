#include "validation/adapters/crack_station.hpp"

#include <cmath>
#include <stdexcept>

namespace cleave::validation {

namespace {

std::vector<geometry::CrackFront> fronts_of(const geometry::Shape& shape) {
    std::vector<geometry::CrackFront> fronts = shape.crack_fronts();
    if (fronts.empty()) throw std::invalid_argument("a body with a crack");
    return fronts;
}

}  // namespace

CrackStation station_near(const geometry::Shape& shape, const Point& point) {
    CrackStation station;
    double nearest = INFINITY;
    for (const geometry::CrackFront& front : fronts_of(shape)) {
        const geometry::FrontPlace place = front.locate(point);
        if (geometry::distance(place) >= nearest) continue;
        nearest = geometry::distance(place);
        station = {front, front.locate(place.position), {}};
    }
    const double half_width = station.front.loop > 0 ? station.front.loop / 20 : INFINITY;
    station.growth = [front = station.front, along = station.place.along, half_width](const Point& x) {
        return geometry::local_growth(front, along, half_width, x);
    };
    return station;
}

std::function<Point(const Point&)> whole_growth(const geometry::Shape& shape) {
    return [fronts = fronts_of(shape)](const Point& x) {
        Point sum{};
        for (const geometry::CrackFront& front : fronts) {
            const Point q = geometry::uniform_growth(front, x);
            for (std::size_t k = 0; k < 3; ++k) sum[k] += q[k];
        }
        return sum;
    };
}

double relative_toughness(const Toughness& toughness, const CrackStation& station, double angle) {
    double cosine = 0;  // between the normals of the planes
    for (std::size_t i = 0; i < 3; ++i)
        cosine += toughness.weak_normal[i] * (std::cos(angle) * station.place.axes[1][i] - std::sin(angle) * station.place.axes[0][i]);
    return cosine * cosine + toughness.ratio * (1 - cosine * cosine);
}

}  // namespace cleave::validation
