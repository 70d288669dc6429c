#pragma once

#include "validation/case.hpp"
#include "validation/samples.hpp"
#include "validation/solve_note.hpp"

#include <map>
#include <memory>
#include <string>

namespace cleave::validation {

/// Finite elements on the case's body: `solver` is fem.p1 or fem.p2. Throws InputError (a region without a material, an
/// unconstrained body, an inverted tet), naming the case's file.
std::unique_ptr<FieldSource> run_fem(const Case& of, const geometry::Body& body, double size, const std::string& solver, SolveNote& note);

/// A strain operator at the centroids of the same mesh: sph.paper, sph.corrected, sph.quadratic or sph.conforming_operator.
/// `displacement` gives u at points, m.
std::unique_ptr<FieldSource> run_particles(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                           const std::function<std::vector<Point>(const std::vector<Point>&)>& displacement, SolveNote& note);

/// Equilibrium of the particles under the case's loads: sph.conforming with the strain and stress it was solved with, or
/// sph.conforming_recovered with these smoothed over the neighbours. Throws InputError.
std::unique_ptr<FieldSource> run_equilibrium(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                             SolveNote& note);

/// The particles relaxed under the forces of Eq. 9: sph.relaxed_paper, sph.relaxed_corrected. The counter-example: it does not converge.
/// Takes bodies whose whole surface follows an analytic displacement. Throws InputError.
std::unique_ptr<FieldSource> run_relaxation(const Case& of, const geometry::Body& body, double size, const std::string& solver,
                                            SolveNote& note);

/// Tags of the surfaces a load acts on; "all" stands for every surface of the body. Throws InputError.
std::vector<int> surface_tags(const SurfaceLoad& load, const geometry::Body& body, const Case& of);

/// An analytic field, evaluated where the method under test has its points.
Samples evaluate(const analytic::Field& field, const std::vector<Point>& points);

/// The material of a region: its own, or the whole body's. Throws InputError.
const material::Material& material_of(const Case& of, const std::string& region);

}  // namespace cleave::validation
