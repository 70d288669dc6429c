#include "validation/adapters/sources.hpp"

namespace cleave::validation {

Samples evaluate(const analytic::Field& field, const std::vector<Point>& points) {
    Samples samples;
    samples.position = points;
    samples.weight.assign(points.size(), 1);
    for (const Point& x : points) {
        samples.displacement.push_back(field.displacement(x));
        samples.strain.push_back(analytic::strain_of(field.gradient(x)));
        samples.stress.push_back(field.stress(x));
    }
    return samples;
}

const material::Material& material_of(const Case& of, const std::string& region) {
    auto found = of.materials.find(region);
    if (found == of.materials.end()) found = of.materials.find("");
    if (found == of.materials.end()) of.fail("material.region", "a material for region '" + region + "'");
    return found->second;
}

}  // namespace cleave::validation
