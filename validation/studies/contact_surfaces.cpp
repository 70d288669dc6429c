#include "validation/studies/contact_surfaces.hpp"

#include "solver/contact/contact_load.hpp"
#include "solver/contact/half_space.hpp"
#include "solver/material/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cleave::validation {

namespace {

/// The material seen along `normal`, with `along` in the surface as x.
ContactSurface cut(const std::string& name, const material::Stiffness& stiffness, const Eigen::Vector3d& normal, const Eigen::Vector3d& along) {
    const Eigen::Matrix3d axes = contact::surface_axes(normal, along);
    return {name, material::rotate_stiffness(stiffness, axes.transpose()), contact::is_isotropic(stiffness)};
}

void add(std::vector<ContactSurface>& list, const material::Material& material) {
    const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const material::Stiffness& c = material.stiffness;
    if (contact::is_isotropic(c)) {
        list.push_back(cut(material.name, c, z, x));
    } else if (material.symmetry == "cubic") {
        list.push_back(cut(material.name + " (100)", c, z, x));
        list.push_back(cut(material.name + " (110)", c, x + y, z));
        list.push_back(cut(material.name + " (111)", c, x + y + z, x - y));
    } else {
        list.push_back(cut(material.name + " in surface", c, z, x));
        list.push_back(cut(material.name + " normal", c, x, y));
    }
}

}  // namespace

std::vector<ContactSurface> contact_surfaces() {
    std::vector<ContactSurface> list;
    for (const std::string& name : material::catalogue_names()) add(list, material::find_material(name));
    return list;
}

std::vector<ContactSurface> contact_surfaces(const std::vector<std::string>& names) {
    const std::vector<ContactSurface> all = contact_surfaces();
    std::vector<ContactSurface> chosen;
    for (const std::string& name : names) {
        const auto at = std::find_if(all.begin(), all.end(), [&](const ContactSurface& one) { return one.name == name; });
        if (at == all.end()) throw std::invalid_argument(fmt::format("a known surface (not '{}')", name));
        chosen.push_back(*at);
    }
    return chosen;
}

std::vector<ContactSurface> read_surfaces(TableReader& study, const std::string& key) {
    try {
        return contact_surfaces(study.strings(key));
    } catch (const std::invalid_argument& error) {
        study.fail(key, error.what());
    }
}

std::vector<ContactSurface> one_surface_of_each() {
    std::vector<ContactSurface> chosen;
    for (const ContactSurface& surface : contact_surfaces())
        if (surface.isotropic || surface.name.ends_with("(111)") || surface.name.ends_with("normal")) chosen.push_back(surface);
    return chosen;
}

std::vector<material::Stiffness> stiffnesses(const std::vector<ContactSurface>& surfaces) {
    std::vector<material::Stiffness> all;
    for (const ContactSurface& surface : surfaces) all.push_back(surface.stiffness);
    return all;
}

analytic::Point plain(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
Eigen::Vector3d eigen(const analytic::Point& p) { return {p[0], p[1], p[2]}; }

double relative(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).norm() / b.norm(); }

}  // namespace cleave::validation
