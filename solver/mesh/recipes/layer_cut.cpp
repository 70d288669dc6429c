#include "solver/mesh/recipes/layer_cut.hpp"

#include "solver/mesh/gmsh_session.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace cleave::mesh {
namespace {

namespace occ = gmsh::model::occ;

constexpr double most_layers = 1000;

/// The corners of the box around volumes.
Eigen::AlignedBox3d box_of(const gmsh::vectorpair& volumes) {
    Eigen::AlignedBox3d box;
    for (const auto& [dimension, tag] : volumes) {
        Eigen::Vector3d low, high;
        occ::getBoundingBox(dimension, tag, low[0], low[1], low[2], high[0], high[1], high[2]);
        box.extend(low).extend(high);
    }
    return box;
}

/// A square of the plane normal . x = distance, wide enough to cut all of the box.
int add_plane(const Eigen::Vector3d& normal, double distance, const Eigen::AlignedBox3d& box) {
    const double width = 2.2 * (box.diagonal().norm() + box.center().norm());
    const int square = occ::addRectangle(-width / 2, -width / 2, 0, width, width);
    const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal));
    const Eigen::Vector3d& axis = turn.axis();
    const Eigen::Vector3d shift = distance * normal;
    if (turn.angle() != 0) occ::rotate({{2, square}}, 0, 0, 0, axis[0], axis[1], axis[2], turn.angle());
    occ::translate({{2, square}}, shift[0], shift[1], shift[2]);
    return square;
}

gmsh::vectorpair add_planes(const Eigen::Vector3d& normal, double thickness, const Eigen::AlignedBox3d& box) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const double along = normal.dot(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))) / thickness;
        low = std::min(low, along);
        high = std::max(high, along);
    }
    if (!(high - low <= most_layers)) throw MeshingError(fmt::format("layers: at most {} of them", most_layers));
    gmsh::vectorpair planes;
    for (long k = std::lround(std::ceil(low)); k <= std::lround(std::floor(high)); ++k) {
        planes.emplace_back(2, add_plane(normal, static_cast<double>(k) * thickness, box));
    }
    return planes;
}

/// Removes the pieces of planes that no volume uses.
void remove_loose_faces(const gmsh::vectorpair& volumes) {
    occ::synchronize();
    gmsh::vectorpair used, faces, loose;
    gmsh::model::getBoundary(volumes, used, false, false);
    const std::set<std::pair<int, int>> kept(used.begin(), used.end());
    occ::getEntities(faces, 2);
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(loose), [&](const auto& face) { return !kept.contains(face); });
    occ::remove(loose, true);
}

}  // namespace

std::vector<Region> cut_into_layers(const std::vector<Region>& regions, const Layers& layers) {
    const Eigen::Vector3d normal = layers.normal.normalized();
    gmsh::vectorpair whole, pieces;
    for (const Region& region : regions) {
        for (const int volume : region.volumes) whole.emplace_back(3, volume);
    }
    const gmsh::vectorpair planes = add_planes(normal, layers.thickness, box_of(whole));
    std::vector<gmsh::vectorpair> unused;
    occ::fragment(whole, planes, pieces, unused);
    std::erase_if(pieces, [](const auto& piece) { return piece.first != 3; });
    remove_loose_faces(pieces);
    std::map<long, Region> found;
    for (const auto& [dimension, tag] : pieces) {
        Eigen::Vector3d centre;  // lies between the piece's two planes
        occ::getCenterOfMass(dimension, tag, centre[0], centre[1], centre[2]);
        found[std::lround(std::floor(normal.dot(centre) / layers.thickness))].volumes.push_back(tag);
    }
    std::vector<Region> result;
    for (auto& [unused_number, region] : found) {
        region.name = fmt::format("layer {}", result.size() + 1);
        result.push_back(std::move(region));
    }
    return result;
}

std::map<int, Eigen::Matrix3d> frames_of(const Layers& layers, const TetMesh& mesh) {
    std::map<int, Eigen::Matrix3d> frames;
    for (const auto& [region, unused] : mesh.region_names) {
        const double angle = layers.angles[static_cast<std::size_t>(region - 1) % layers.angles.size()];
        frames[region] = Eigen::AngleAxisd(angle, layers.normal.normalized()).toRotationMatrix();
    }
    return frames;
}

std::string text_of(const Layers& layers) {
    const Eigen::Vector3d& n = layers.normal;
    return fmt::format("layers normal {:.17g} {:.17g} {:.17g} thickness {:.17g} angles {:.17g}", n[0], n[1], n[2], layers.thickness,
                       fmt::join(layers.angles, " "));
}

}  // namespace cleave::mesh
