#pragma once

#include "validation/analytic/field.hpp"
#include "validation/expression.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace cleave::validation {

using analytic::Voigt;

/// A field known at points. Arrays have one entry per point; `weight` is the volume a point stands for (m^3).
struct Samples {
    std::vector<Point> position;
    std::vector<double> weight;
    std::vector<Point> displacement;  ///< m
    std::vector<Voigt> strain;        ///< engineering shear
    std::vector<Voigt> stress;        ///< Pa
    std::size_t size() const { return position.size(); }
};

/// How fine a result is. Counts that do not apply are zero.
struct Resolution {
    double size = 0;     ///< element size, m
    long particles = 0;  ///< also the number of tetrahedra
    long dofs = 0;
};

/// Direction of a largest principal stress and its gap to the second, over the tensor's norm.
struct PrincipalAxis {
    Point direction{};  ///< unit vector without sense
    double gap = 0;
};

/// A solver's answer on one mesh.
class FieldSource {
public:
    virtual ~FieldSource() = default;
    /// The method's own points: quadrature points of the FEM, particles of the SPH.
    virtual const Samples& everywhere() const = 0;
    /// Values at given points, the most accurate the method offers. Throws InputError where the method has none.
    virtual Samples at(const std::vector<Point>& points) const = 0;
    /// Plain (not recovered) values at points inside the body, for comparisons point by point.
    virtual Samples inside(const std::vector<Point>& points) const { return at(points); }
    /// A quantity of the whole body (see scalar_quantities()), SI. Throws InputError where the method does not have it.
    virtual double scalar(const std::string& quantity) const = 0;
    /// A quantity of the crack's front (see is_front_quantity) at the place nearest to a point, SI. Throws std::invalid_argument where the
    /// method does not have it.
    virtual double at_front(const std::string& quantity, const std::string& component, const Point& place) const {
        (void)component, (void)place;
        throw std::invalid_argument("a solver that has the quantity " + quantity);
    }
    /// The largest principal stress at a point. Throws std::invalid_argument where the method does not have it.
    virtual PrincipalAxis principal_stress(const Point& point) const {
        (void)point;
        throw std::invalid_argument("a solver that has the principal stress at a point");
    }
    virtual Resolution resolution() const = 0;
    /// The fields as a VTU file's text; empty where the method writes none.
    virtual std::string vtu() const { return {}; }
};

}  // namespace cleave::validation
