#pragma once

#include "solver/simulation/simulation.hpp"
#include "validation/study.hpp"

#include <map>
#include <string>
#include <vector>

namespace cleave::validation {

/// What scene_figures() measures, with units.
std::vector<QuantityInfo> scene_quantities();

/// Figures of a scene that has run for a while, SI, by quantity:
///
///   physical, subdivided, fragments     particles at the start and now, pieces
///   lost_share                          of the mass, that is not in the heaviest piece
///   crack_deviation                     root mean square distance of the crack faces' centroids from the nearest crack plane of their body, by
///                                       area. Stated planes pass through the contact; those an interface made do not, so for one material only
///   surface_angle, hole_radius          of the first contact that cracked: mean angle of crack normals to the surface's normal, mean inner radius
///   rim_pieces                          pieces that are held
///   bodies_broken                       bodies in more than one piece
///   least_difference                    over pairs of bodies: half the sum of differences between their pieces' shares of mass, largest first
///   mass_error, momentum_error, angular_momentum_error   worst of any fracture, relative (statistics.json)
///   energy_growth                       largest growth of a piece's energy in a step in which nothing touched it, over the scene's largest kinetic energy
///   free_steps                          how many such steps of pieces there were
///   penetration                         deepest overlap of boundary particles
std::map<std::string, double> scene_figures(const simulation::Simulation& run);

}  // namespace cleave::validation
