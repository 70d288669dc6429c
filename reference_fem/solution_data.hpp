#pragma once

#include "reference_fem/constitutive.hpp"
#include "reference_fem/discretization.hpp"
#include "reference_fem/point_locator.hpp"
#include "reference_fem/solution.hpp"

namespace cleave::fem {

/// All that a Solution can be asked about. Addresses inside refer to each other: built in place, never moved.
struct Solution::Data {
    Data(Mesh read, const Options& options, std::vector<Region> regions);
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;

    /// Displacement gradient and displacement of a cell, from shape functions tabulated at a point of the unit tet.
    struct Local {
        Point position{};
        Point displacement{};
        Tensor gradient{};
        double volume_factor = 0;  ///< determinant of the map from the unit tet: 6 times the volume
        std::vector<Point> shape_gradients;
    };
    Local evaluate(int cell, const std::vector<double>& values, const std::vector<Point>& unit_gradients, const Point& unit) const;
    FieldSample sample(int cell, const Local& local) const;
    FieldSample sample(const PointLocator::Place& place) const;
    PointLocator::Place locate(const Point& point) const;

    Mesh mesh;
    Options options;
    std::vector<Elasticity> elasticities;
    std::vector<const Elasticity*> materials;  // one per cell
    Discretization space;
    PointLocator locator;
    std::vector<double> displacement;  // m, by dof
    SolveRecord record;
    double energy = 0;
    double external_work = 0;
};

/// Shape functions at each point of a quadrature rule.
struct ShapeTable {
    ShapeTable(const Discretization& space, int order);
    Discretization::Quadrature rule;
    std::vector<std::vector<double>> values;
    std::vector<std::vector<Point>> gradients;
};

}  // namespace cleave::fem
