#pragma once

#include "reference_fem/discretization.hpp"

#include <vector>

namespace cleave::fem {

/// A surface with the nodes on it numbered, and a quadrature fine enough for integrands with a kink: 48 points a triangle.
class ContactSurface {
public:
    ContactSurface(const std::vector<BoundaryFace>& faces, const Mesh& mesh, const Discretization& space);

    struct SurfacePoint {
        Point position{};
        double area = 0;  ///< m^2
        std::vector<int> nodes;
        std::vector<double> shape;
    };
    const std::vector<SurfacePoint>& points() const { return points_; }
    /// Dof of the displacement along z of each node.
    const std::vector<int>& normal_dofs() const { return normal_dofs_; }
    double area() const;

private:
    std::vector<SurfacePoint> points_;
    std::vector<int> normal_dofs_;
};

}  // namespace cleave::fem
