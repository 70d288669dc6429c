#include "solver/mesh/gmsh_session.hpp"

#include <gmsh.h>

#include <algorithm>
#include <atomic>

namespace cleave::mesh {
namespace {

constexpr int triangle_type = 2, tet_type = 4;
constexpr int throw_always = 3;  ///< of General.AbortOnError

/// Gmsh node tags to vertex numbers; -1 for tags that no tet uses.
class NodeNumbers {
public:
    explicit NodeNumbers(TetMesh& mesh) {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates, parameters;
        gmsh::model::mesh::getNodes(tags, coordinates, parameters);
        std::size_t largest = 0;
        for (const std::size_t tag : tags) largest = std::max(largest, tag);
        numbers_.assign(largest + 1, -1);
        for (const std::size_t tag : used_by_tets()) numbers_[tag] = 0;
        std::vector<std::size_t> rows(largest + 1, 0);
        for (std::size_t row = 0; row < tags.size(); ++row) rows[tags[row]] = row;
        for (std::size_t tag = 0; tag <= largest; ++tag) {
            if (numbers_[tag] < 0) continue;
            numbers_[tag] = static_cast<int>(mesh.vertices.size());
            const double* x = &coordinates[3 * rows[tag]];
            mesh.vertices.emplace_back(x[0], x[1], x[2]);
        }
    }

    int operator[](std::size_t tag) const { return numbers_[tag]; }

private:
    static std::vector<std::size_t> used_by_tets() {
        std::vector<std::size_t> elements, nodes;  // fresh ones: getElementsByType throws on vectors that are not empty
        gmsh::model::mesh::getElementsByType(tet_type, elements, nodes);
        return nodes;
    }

    std::vector<int> numbers_;
};

int physical_tag(int dimension, int entity) {
    std::vector<int> tags;
    gmsh::model::getPhysicalGroupsForEntity(dimension, entity, tags);
    return tags.empty() ? 0 : tags.front();
}

/// Calls visit(physical tag, nodes) for each element of a type, entity by entity.
template <class Visit>
void for_each_element(int dimension, int type, std::size_t nodes_each, const Visit& visit) {
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities, dimension);
    for (const auto& [unused, entity] : entities) {
        std::vector<std::size_t> elements, nodes;
        gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
        const int tag = physical_tag(dimension, entity);
        for (std::size_t i = 0; i < elements.size(); ++i) visit(tag, &nodes[nodes_each * i]);
    }
}

std::map<int, std::string> group_names(int dimension) {
    std::map<int, std::string> names;
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, dimension);
    for (const auto& [unused, tag] : groups) {
        std::string name;
        gmsh::model::getPhysicalName(dimension, tag, name);
        if (!name.empty()) names[tag] = name;
    }
    return names;
}

void set_options() {
    using gmsh::option::setNumber;
    setNumber("General.Terminal", 0);
    setNumber("General.AbortOnError", throw_always);
    setNumber("General.NumThreads", 1);
    setNumber("Mesh.Algorithm", 6);  // frontal Delaunay
    setNumber("Mesh.Algorithm3D", 1);
    setNumber("Mesh.RandomSeed", 1);
    setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
    setNumber("Mesh.MeshSizeFromPoints", 0);
    setNumber("Mesh.MeshSizeFromCurvature", 0);
    setNumber("Mesh.Binary", 0);
    setNumber("Mesh.MshFileVersion", 4.1);
}

/// Mirrors the one mutable state that is global already: Gmsh itself (4.8 has no way to ask it).
std::atomic<bool>& in_use() {
    static std::atomic<bool> flag{false};
    return flag;
}

}  // namespace

GmshSession::GmshSession() {
    if (in_use().exchange(true)) throw std::logic_error("GmshSession: Gmsh is in use already");
    run([] {
        gmsh::initialize(0, nullptr, false);
        set_options();
    });
}

GmshSession::~GmshSession() {
    try {
        gmsh::finalize();
    } catch (...) {
        // A destructor has nobody to tell; a Gmsh that cannot finalize shows itself at the next session.
    }
    in_use() = false;
}

void GmshSession::new_model(const std::string& name) const {
    run([&] {
        gmsh::clear();
        gmsh::model::add(name);
    });
}

void GmshSession::set_uniform_size(double size) const {
    run([&] {
        gmsh::option::setNumber("Mesh.MeshSizeMin", size);
        gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    });
}

void GmshSession::generate() const {
    // Gmsh meshes surfaces inside an OpenMP region, which no exception may leave: errors go into its log meanwhile.
    std::vector<std::string> log;
    run([&] {
        gmsh::option::setNumber("General.AbortOnError", 0);
        gmsh::logger::start();
        gmsh::model::mesh::generate(3);
        gmsh::logger::get(log);
        gmsh::logger::stop();
        gmsh::option::setNumber("General.AbortOnError", throw_always);
    });
    for (const std::string& line : log) {
        if (line.starts_with("Error")) throw MeshingError("gmsh: " + one_line(line));
    }
}

TetMesh GmshSession::take_mesh() const {
    return run([] {
        TetMesh mesh;
        const NodeNumbers number(mesh);
        for_each_element(3, tet_type, 4, [&](int tag, const std::size_t* nodes) {
            mesh.tets.push_back({number[nodes[0]], number[nodes[1]], number[nodes[2]], number[nodes[3]]});
            mesh.regions.push_back(tag);
        });
        for_each_element(2, triangle_type, 3, [&](int tag, const std::size_t* nodes) {
            if (tag != 0) mesh.surface.push_back({{number[nodes[0]], number[nodes[1]], number[nodes[2]]}, tag});
        });
        if (mesh.tets.empty()) throw MeshingError("gmsh: the mesh has no tets");
        mesh.region_names = group_names(3);
        mesh.surface_names = group_names(2);
        return mesh;
    });
}

std::string GmshSession::version() { return GMSH_API_VERSION; }

std::string GmshSession::one_line(const std::string& message) {
    std::string line = message;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

}  // namespace cleave::mesh
