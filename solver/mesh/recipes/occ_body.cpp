#include "solver/mesh/recipes/occ_body.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/recipes/layer_cut.hpp"
#include "solver/mesh/size_tuning.hpp"
#include "solver/mesh/surface_check.hpp"
#include "solver/mesh/surface_marks.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <stdexcept>

namespace cleave::mesh {
namespace {

std::vector<Region> built(const OccBody& body, const OccRequest& request) {
    std::vector<Region> regions = body.build();
    if (request.layers) regions = cut_into_layers(regions, *request.layers);
    gmsh::model::occ::synchronize();
    return regions;
}

void name_groups(const std::vector<Region>& regions) {
    int number = 0;
    gmsh::vectorpair volumes, surfaces;
    for (const Region& region : regions) {
        gmsh::model::addPhysicalGroup(3, region.volumes, ++number);
        gmsh::model::setPhysicalName(3, number, region.name);
        for (const int volume : region.volumes) volumes.emplace_back(3, volume);
    }
    gmsh::model::getBoundary(volumes, surfaces, true, false);
    std::vector<int> tags;
    for (const auto& [unused, tag] : surfaces) tags.push_back(tag);
    gmsh::model::addPhysicalGroup(2, tags, 1);
    gmsh::model::setPhysicalName(2, 1, "outside");
}

TetMesh meshed_by_gmsh(const OccBody& body, const OccRequest& request) {
    const GmshSession session;
    session.new_model(body.name);
    session.run([&] { name_groups(built(body, request)); });
    const auto make = [&](double size) {
        session.run([] { gmsh::model::mesh::clear(); });
        session.set_uniform_size(size);
        session.generate();
        TetMesh mesh = session.take_mesh();
        const bool strays = std::find(mesh.regions.begin(), mesh.regions.end(), 0) != mesh.regions.end();
        if (strays) throw std::logic_error(body.name + ": the recipe left a volume behind that belongs to no region");
        return mesh;
    };
    return tune_count(make, body.first_size, request.target).mesh;
}

/// The boundary as a surface of its own, without the mesh's inner vertices.
SurfaceMesh surface_of(const TetMesh& mesh) {
    SurfaceMesh surface;
    std::vector<int> number(mesh.vertices.size(), -1);
    for (SurfaceTriangle triangle : boundary_of(mesh)) {
        for (int& vertex : triangle.vertices) {
            if (number[vertex] < 0) {
                number[vertex] = static_cast<int>(surface.vertices.size());
                surface.vertices.push_back(mesh.vertices[vertex]);
            }
            vertex = number[vertex];
        }
        surface.triangles.push_back({triangle.vertices, 0});
    }
    return surface;
}

/// The shape's surface as triangles, outward: the boundary of a Gmsh mesh of that size.
SurfaceMesh facetted(const OccBody& body, const OccRequest& request) {
    const GmshSession session;
    session.new_model(body.name);
    session.run([&] { name_groups(built(body, request)); });
    session.set_uniform_size(body.facet);
    session.generate();
    return surface_of(session.take_mesh());
}

TetMesh meshed_by_netgen(const OccBody& body, const OccRequest& request) {
    const SurfaceMesh surface = facetted(body, request);
    try {
        check_surface(surface, body.name);
    } catch (const InputError& error) {
        throw MeshingError(fmt::format("the surface for NETGEN is broken: {}", error.what()));
    }
    TetMesh mesh = mesh_surface_to_count(surface, request.target, Mesher::netgen).mesh;
    mesh.region_names = {{1, body.name}};
    return mesh;
}

std::string recipe_text(const OccBody& body, const OccRequest& request) {
    std::string text = fmt::format("{} {}: target {}, {}", body.name, body.parameters, request.target, version_of(request.mesher));
    if (request.mesher == Mesher::netgen) text += fmt::format(", facets {:.17g} by {}", body.facet, version_of(Mesher::gmsh));
    return request.layers ? text + ", " + text_of(*request.layers) : text;
}

}  // namespace

Body mesh_occ_body(const OccBody& body, const OccRequest& request, const std::filesystem::path& cache) {
    const bool netgen = request.mesher == Mesher::netgen;
    if (netgen && (body.facet == 0 || request.layers)) {
        throw MeshingError(fmt::format("{}: netgen meshes bodies of one region without layers or cavities only; take gmsh", body.name));
    }
    Body made = cached_body(body.name, recipe_text(body, request), request.target, cache,
                            [&] { return netgen ? meshed_by_netgen(body, request) : meshed_by_gmsh(body, request); });
    if (request.layers) made.frames = frames_of(*request.layers, made.mesh);
    return made;
}

}  // namespace cleave::mesh
