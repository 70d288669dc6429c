#include "solver/mesh/recipes/pet.hpp"

#include "solver/mesh/gmsh_session.hpp"

#include <Eigen/Core>
#include <fmt/format.h>
#include <gmsh.h>

namespace cleave::mesh {
namespace {

namespace occ = gmsh::model::occ;
using Part = std::pair<int, int>;

/// Everything below is in parts of the body's length; the walls are not.
class PetBuilder {
public:
    explicit PetBuilder(const PetShape& shape) : shape_(shape) {}

    int build() const {
        gmsh::vectorpair outer{body(0), head(0), tail(), ear(1), ear(-1)};
        for (const double x : {-0.24, 0.24}) {
            for (const double side : {-1.0, 1.0}) outer.push_back(leg(x, side));
        }
        gmsh::vectorpair solid, hollow;
        std::vector<gmsh::vectorpair> unused;
        occ::fuse({outer.front()}, {outer.begin() + 1, outer.end()}, solid, unused);
        occ::cut(solid, {body(shape_.wall), head(shape_.wall)}, hollow, unused);
        if (hollow.size() != 1) throw MeshingError(fmt::format("pet: the shape falls into {} pieces", hollow.size()));
        return hollow.front().second;
    }

private:
    Part ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& axes, double inset) const {
        const Eigen::Vector3d c = shape_.length * centre, a = shape_.length * axes - Eigen::Vector3d::Constant(inset);
        const Part sphere{3, occ::addSphere(c[0], c[1], c[2], 1)};
        occ::dilate({sphere}, c[0], c[1], c[2], a[0], a[1], a[2]);
        return sphere;
    }

    Part cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& along, double radius) const {
        const Eigen::Vector3d f = shape_.length * from, a = shape_.length * along;
        return {3, occ::addCylinder(f[0], f[1], f[2], a[0], a[1], a[2], shape_.length * radius)};
    }

    Part body(double inset) const { return ellipsoid({0, 0, 0.48}, {0.5, 0.29, 0.27}, inset); }
    Part head(double inset) const { return ellipsoid({0.53, 0, 0.80}, {0.24, 0.22, 0.22}, inset); }
    Part ear(double side) const { return cylinder({0.52, 0.05 * side, 0.86}, {-0.05, 0.14 * side, 0.26}, 0.055); }
    Part leg(double x, double side) const { return cylinder({x, 0.11 * side, 0}, {0, 0, 0.40}, 0.07); }
    Part tail() const { return cylinder({-0.40, 0, 0.52}, {-0.34, 0, 0.20}, 0.05); }

    const PetShape& shape_;
};

}  // namespace

OccBody pet_body(const PetShape& s) {
    return {"pet", fmt::format("1 length {:.17g} wall {:.17g}", s.length, s.wall),
            [s] { return std::vector<Region>{{"pet", {PetBuilder(s).build()}}}; }, s.wall / 1.5, 0};
}

}  // namespace cleave::mesh
