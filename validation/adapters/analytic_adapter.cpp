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

std::vector<int> surface_tags(const SurfaceLoad& load, const geometry::Body& body, const Case& of) {
    std::vector<int> tags;
    for (const std::string& name : load.on) {
        if (name == "all")
            for (const auto& [each, tag] : body.surfaces) tags.push_back(tag);
        else if (body.surfaces.count(name))
            tags.push_back(body.surfaces.at(name));
        else
            of.fail("load.on", "a surface of the mesh (not '" + name + "')");
    }
    return tags;
}

}  // namespace cleave::validation
