#include "solver/mesh/mesh_report.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <map>
#include <numbers>
#include <vector>

namespace cleave::mesh {
namespace {

using Json = nlohmann::ordered_json;

/// Elements of one tag, and their volume or area.
struct Part {
    long count = 0;
    double measure = 0;
};

double area(const TetMesh& mesh, const std::array<int, 3>& t) {
    const auto& x = mesh.vertices;
    return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
}

std::map<int, Part> regions_of(const TetMesh& mesh) {
    std::map<int, Part> parts;
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) {
        Part& part = parts[mesh.regions[tet]];
        ++part.count;
        part.measure += tet_volume(mesh, static_cast<int>(tet));
    }
    return parts;
}

std::map<int, Part> surfaces_of(const TetMesh& mesh) {
    std::map<int, Part> parts;
    for (const SurfaceTriangle& triangle : mesh.surface) {
        Part& part = parts[triangle.id];
        ++part.count;
        part.measure += area(mesh, triangle.vertices);
    }
    return parts;
}

double boundary_area(const TetMesh& mesh) {
    const HalfFaceLinks links = link_half_faces(mesh);
    double sum = 0;
    for (std::size_t half_face = 0; half_face < links.opposite.size(); ++half_face) {
        if (links.opposite[half_face] < 0) sum += area(mesh, face_of(mesh.tets[half_face / 4], static_cast<int>(half_face % 4)));
    }
    return sum;
}

std::string name_of_tag(int tag, const std::map<int, std::string>& names) {
    const auto found = names.find(tag);
    return found == names.end() ? std::to_string(tag) : found->second;
}

Json list(const std::map<int, Part>& parts, const std::map<int, std::string>& names, const char* counted, const char* measured) {
    Json items = Json::array();
    for (const auto& [tag, part] : parts) {
        items.push_back({{"tag", tag}, {"name", name_of_tag(tag, names)}, {counted, part.count}, {measured, part.measure}});
    }
    return items;
}

double in_degrees(double angle) { return angle * 180 / std::numbers::pi; }

}  // namespace

Json mesh_json(const Body& body) {
    const TetMesh& mesh = body.mesh;
    return {{"schema", "cleave.mesh/1"},
            {"recipe", body.record.recipe},
            {"target", body.record.target > 0 ? Json(body.record.target) : Json(nullptr)},
            {"tets", mesh.tets.size()},
            {"vertices", mesh.vertices.size()},
            {"smallest_dihedral_deg", in_degrees(body.record.smallest_dihedral)},
            {"slivers", body.record.slivers},
            {"volume_m3", total_volume(mesh)},
            {"surface_m2", boundary_area(mesh)},
            {"regions", list(regions_of(mesh), mesh.region_names, "tets", "volume_m3")},
            {"surfaces", list(surfaces_of(mesh), mesh.surface_names, "triangles", "area_m2")}};
}

std::string mesh_text(const Body& body) {
    const TetMesh& mesh = body.mesh;
    const std::string target = body.record.target > 0 ? fmt::format(" (asked for: {})", body.record.target) : "";
    std::string text = fmt::format("tets                {}{}\nvertices            {}\n", mesh.tets.size(), target, mesh.vertices.size());
    text += fmt::format("smallest dihedral   {:.2f} deg ({} tets under 5 deg)\n", in_degrees(body.record.smallest_dihedral), body.record.slivers);
    text += fmt::format("volume              {:.9g} m^3\nsurface             {:.9g} m^2\n", total_volume(mesh), boundary_area(mesh));
    for (const auto& [tag, part] : regions_of(mesh)) {
        text += fmt::format("region {:<12} {:>8} tets      {:.6g} m^3\n", name_of_tag(tag, mesh.region_names), part.count, part.measure);
    }
    for (const auto& [tag, part] : surfaces_of(mesh)) {
        text += fmt::format("surface {:<11} {:>8} triangles {:.6g} m^2\n", name_of_tag(tag, mesh.surface_names), part.count, part.measure);
    }
    return text;
}

}  // namespace cleave::mesh
