#include "validation/geometry/imported.hpp"

#include "solver/mesh/check.hpp"
#include "solver/mesh/msh_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace cleave::geometry {

namespace {

std::string name_of(int tag, const std::map<int, std::string>& names) {
    const auto found = names.find(tag);
    return found == names.end() ? fmt::format("{}", tag) : found->second;
}

class Imported final : public Shape {
public:
    explicit Imported(const std::filesystem::path& file) {
        const mesh::TetMesh mesh = mesh::read_msh(file);
        mesh::check(mesh, file.string());
        body_.mesh_file = file;
        for (const mesh::SurfaceTriangle& triangle : mesh.surface) body_.surfaces[name_of(triangle.id, mesh.surface_names)] = triangle.id;
        for (const int region : mesh.regions) body_.regions[name_of(region, mesh.region_names)] = region;
        size_ = std::cbrt(6 * std::sqrt(2.0) * mesh::total_volume(mesh) / static_cast<double>(mesh.tets.size()));
    }

    Body mesh(double, const std::filesystem::path&) const override { return body_; }
    validation::Coordinates coordinates() const override {
        return {{"x", [](const auto& p) { return p[0]; }}, {"y", [](const auto& p) { return p[1]; }}, {"z", [](const auto& p) { return p[2]; }}};
    }
    double length(const std::string& key) const override {
        if (key == "mesh_size") return size_;  // edge of the regular tet of mean volume
        throw std::invalid_argument(fmt::format("one of mesh_size (not '{}')", key));
    }
    std::vector<std::filesystem::path> input_files() const override { return {body_.mesh_file}; }
    bool uniform_refinement() const override { return false; }
    std::vector<std::string> surface_names() const override {
        std::vector<std::string> names;
        for (const auto& [name, tag] : body_.surfaces) names.push_back(name);
        return names;
    }

private:
    Body body_;
    double size_ = 0;
};

}  // namespace

ShapeInfo imported_info() {
    return {"mesh = \"file.msh\"", "a user's own tetrahedral mesh (.msh 2.2 or 4.1)", {"mesh"}, {"names or tags of the file"}, {"x", "y", "z"}};
}

std::shared_ptr<const Shape> read_imported(TableReader& geometry) {
    std::filesystem::path file = geometry.string("mesh");
    if (file.is_relative() && !std::filesystem::exists(file)) {
        const std::filesystem::path beside = std::filesystem::path(geometry.file()).parent_path() / file;
        if (std::filesystem::exists(beside)) file = beside;
    }
    if (!std::filesystem::exists(file)) geometry.fail("mesh", fmt::format("an existing file (not '{}')", file.string()));
    if (file.extension() != ".msh") geometry.fail("mesh", "a .msh file (other formats follow)");
    return std::make_shared<Imported>(file);
}

}  // namespace cleave::geometry
