#pragma once

#include "reference_fem/problem.hpp"
#include "reference_fem/solution.hpp"

namespace cleave::fem {

/// A rigid body without friction, pressed along -z against the plane top z = 0 of a body that stands for a half-space of any stiffness.
/// The body is cut out of the half-space at `outer`. There its displacement is neither zero nor free: far from the contact the field of
/// the half-space falls like 1/distance along every ray from the origin, whatever the stiffness (it is that of a point force), so
/// u(x) = u(x/2) / 2 is asked for. What is left out falls like (contact radius / width)^2 in u(x) there, and so as the third
/// power at the contact.
struct Indentation {
    enum class Shape {
        flat_punch,  ///< a circle of the given radius, all of it in contact: `contact` must be that circle
        sphere       ///< a paraboloid of the given radius of curvature, as in Hertz's theory: `contact` must hold all that may touch it
    };
    std::string mesh_file;
    std::vector<Region> regions;
    std::vector<Displacement> symmetry;  ///< planes through the z axis, where the body is a half or a quarter
    double share = 1;                    ///< the body's part of the whole: 1, 1/2, 1/4
    int contact = 0;                     ///< surface
    int outer = 0;                       ///< surface
    Shape shape = Shape::flat_punch;
    double radius = 0;  ///< m
    double depth = 0;   ///< m, of a flat punch: how far it goes in
    double force = 0;   ///< N, of a sphere, on the whole body
};

/// Pressure at a place of the top, on the body.
struct PressureSample {
    Point position{};
    double area = 0;      ///< m^2 it stands for
    double pressure = 0;  ///< Pa
};

struct IndentationResult {
    Solution solution;
    double force = 0;           ///< N, on the whole body
    double depth = 0;           ///< m, approach of the indenter and the far end of the half-space
    double contact_radius = 0;  ///< m; where the pressure ends (sphere); of the circle of the same area as the facets (punch)
    double peak_pressure = 0;   ///< Pa, at the centre, by a quadratic fit over half the contact radius (sphere); 0 for a punch
    int iterations = 0;         ///< Newton steps of the contact
    int far_field_iterations = 0;
    std::vector<PressureSample> pressure;  ///< places under pressure; sphere only
};

/// A punch prescribes the displacements under it. Against a sphere the part of the top that may touch is condensed: its compliance (one column
/// per node, by back-substitution) and the far field leave a dense problem in its normal displacements, where a penalty acts at the points
/// of a fine quadrature, p = penalty * max(0, overlap), solved by Newton's method. The penalty is 1000 times the mean pressure over the mean
/// displacement of a uniformly loaded surface: the overlap is a thousandth of the depth. Options::solver does not count (always direct).
/// Throws Error as `solve` does, and where the contact reaches the rim of its surface.
IndentationResult solve_indentation(const Indentation& indentation, const Options& options = {});

}  // namespace cleave::fem
