#include "validation/geometry/imported.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "solver/mesh/import.hpp"
#include "solver/mesh/mesher.hpp"
#include "solver/mesh/msh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace cleave::geometry {

namespace {

std::string name_of(int tag, const std::map<int, std::string>& names) {
    const auto found = names.find(tag);
    return found == names.end() ? fmt::format("{}", tag) : found->second;
}

class Imported : public Shape {
public:
    validation::Coordinates coordinates() const override {
        return {{"x", [](const auto& p) { return p[0]; }}, {"y", [](const auto& p) { return p[1]; }}, {"z", [](const auto& p) { return p[2]; }}};
    }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override {
        std::vector<std::string> names;
        for (const auto& [name, tag] : body_.surfaces) names.push_back(name);
        return names;
    }

protected:
    void name_surfaces(const std::vector<mesh::SurfaceTriangle>& triangles, const std::map<int, std::string>& names) {
        for (const mesh::SurfaceTriangle& triangle : triangles) body_.surfaces[name_of(triangle.id, names)] = triangle.id;
    }

    Body body_;  ///< without the mesh file, where that has to be made
};

/// Tets as they are. What is no .msh becomes one, once, for both solvers.
class ImportedTets final : public Imported {
public:
    ImportedTets(const mesh::TetMesh& mesh, const std::filesystem::path& file) {
        name_surfaces(mesh.surface, mesh.surface_names);
        for (const int region : mesh.regions) body_.regions[name_of(region, mesh.region_names)] = region;
        size_ = std::cbrt(6 * std::sqrt(2.0) * mesh::total_volume(mesh) / static_cast<double>(mesh.tets.size()));
        body_.mesh_file = file;
        if (file.extension() != ".msh") text_ = mesh::format_msh(mesh);
    }

    Body mesh(double, const std::filesystem::path& folder) const override {
        if (text_.empty()) return body_;
        Body body = body_;
        body.mesh_file = folder / fmt::format("imported-{}.msh", content_hash(text_));
        if (!std::filesystem::exists(body.mesh_file)) write_file_atomic(body.mesh_file, text_);
        return body;
    }
    double length(const std::string& key) const override {
        if (key == "mesh_size") return size_;  // edge of the regular tet of mean volume
        throw std::invalid_argument(fmt::format("one of mesh_size (not '{}')", key));
    }

private:
    std::string text_;  ///< of the .msh to write; empty where the file is one
    double size_ = 0;
};

/// A surface, meshed at the ladder's size.
class ImportedSurface final : public Imported {
public:
    ImportedSurface(mesh::SurfaceMesh surface, const std::filesystem::path& file, mesh::Mesher mesher)
        : surface_(std::move(surface)), file_(file.string()), recipe_(fmt::format("surface 1 {} {}", content_hash(read_file(file)), mesh::version_of(mesher))), mesher_(mesher) {
        const bool patches = std::any_of(surface_.triangles.begin(), surface_.triangles.end(), [](const auto& triangle) { return triangle.id != 0; });
        if (patches) name_surfaces(surface_.triangles, surface_.names);
        else body_.surfaces["outside"] = 1;
        body_.regions["1"] = 1;
    }

    Body mesh(double size, const std::filesystem::path& folder) const override {
        Body body = body_;
        body.mesh_file = folder / fmt::format("surface-{}.msh", content_hash(fmt::format("{} size {:.17g}", recipe_, size)));
        if (std::filesystem::exists(body.mesh_file)) return body;
        try {
            mesh::write_msh(mesh::mesh_surface(surface_, size, mesher_), body.mesh_file);
        } catch (const mesh::MeshingError& error) {
            throw InputError(file_, "", fmt::format("a surface that can be meshed at size {:.4g} m: {}", size, error.what()));
        }
        return body;
    }
    double length(const std::string& key) const override {
        if (key != "extent") throw std::invalid_argument(fmt::format("one of extent (not '{}')", key));
        Eigen::Vector3d low = surface_.vertices.front(), high = low;
        for (const Eigen::Vector3d& x : surface_.vertices) low = low.cwiseMin(x), high = high.cwiseMax(x);
        return (high - low).maxCoeff();
    }

private:
    mesh::SurfaceMesh surface_;
    std::string file_, recipe_;
    mesh::Mesher mesher_;
};

}  // namespace

ShapeInfo imported_info() {
    return {"mesh = \"file\"", "a user's own body: tets (.msh, .mesh, .vtu), or a surface that is meshed (.stl, .obj, .mesh, .vtu)", {"mesh", "mesher (surfaces: netgen, gmsh)"},
            {"names or tags of the file; patches between sharp edges: 1, 2, ...; else outside"}, {"x", "y", "z"}};
}

std::shared_ptr<const Shape> read_imported(TableReader& geometry) {
    const std::filesystem::path file = geometry.existing_file("mesh");
    mesh::Imported imported = mesh::import_mesh(file);
    if (const auto* tets = std::get_if<mesh::TetMesh>(&imported)) return std::make_shared<ImportedTets>(*tets, file);
    const mesh::Mesher mesher = mesh::mesher_of(geometry.choice_or("mesher", mesh::mesher_names(), "netgen"));
    return std::make_shared<ImportedSurface>(std::move(std::get<mesh::SurfaceMesh>(imported)), file, mesher);
}

}  // namespace cleave::geometry
