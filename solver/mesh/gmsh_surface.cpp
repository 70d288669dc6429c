#include "solver/mesh/gmsh_surface.hpp"

#include "solver/mesh/gmsh_session.hpp"

#include <gmsh.h>

namespace cleave::mesh {
namespace {

constexpr int triangle_type = 2;

int add_triangles(const SurfaceMesh& surface) {
    const int entity = gmsh::model::addDiscreteEntity(2);
    std::vector<std::size_t> tags(surface.vertices.size()), corners;
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < tags.size(); ++i) {
        tags[i] = i + 1;
        coordinates.insert(coordinates.end(), surface.vertices[i].begin(), surface.vertices[i].end());
    }
    for (const SurfaceTriangle& triangle : surface.triangles) {
        for (const int vertex : triangle.vertices) corners.push_back(static_cast<std::size_t>(vertex) + 1);
    }
    gmsh::model::mesh::addNodes(2, entity, tags, coordinates);
    gmsh::model::mesh::addElementsByType(entity, triangle_type, {}, corners);
    return entity;
}

void build(const SurfaceMesh& surface) {
    const int shell = gmsh::model::geo::addSurfaceLoop({add_triangles(surface)});
    const int volume = gmsh::model::geo::addVolume({shell});
    gmsh::model::geo::synchronize();
    gmsh::model::addPhysicalGroup(3, {volume}, 1);
}

}  // namespace

TetMesh mesh_by_gmsh(const SurfaceMesh& surface, double size) {
    const GmshSession session;
    session.new_model("surface");
    session.run([&] { build(surface); });
    session.set_uniform_size(size);
    session.generate();
    return session.take_mesh();
}

}  // namespace cleave::mesh
