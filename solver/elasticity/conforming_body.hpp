#pragma once

#include "solver/elasticity/conforming_traces.hpp"
#include "solver/elasticity/strain.hpp"

#include <map>

namespace cleave::elasticity {

/// A body as the `conforming` operator sees it (stabilised conforming nodal integration, Chen et al. 2001, on the particles' own tets):
///
///   grad u_i = (1/V_i) sum over the four faces f of A_f u_f (x) n_f,   u_f = sum_k phi_fk u_k
///
/// with one trace u_f per face, so that interior faces cancel exactly in any sum over particles.
struct ConformingBody {
    particles::Particles particles;
    FaceSet faces;
    Solid solid;
    TraceStencils stencils;
    TraceWeights traces;
};

/// One material per distinct stiffness: regions of equal stiffness are one material, and no interface lies between them.
/// Throws std::invalid_argument where a region has no stiffness.
Solid solid_of_regions(const std::vector<int>& region, const std::map<int, material::Stiffness>& stiffness);

/// Particles, faces and traces of a mesh. Throws std::invalid_argument (inverted tet, region without stiffness).
ConformingBody make_conforming_body(const mesh::TetMesh& mesh, const std::map<int, material::Stiffness>& stiffness,
                                    const TraceRule& rule = {});

/// The same with particles whose kernels the caller has shaped (tensors count by their shape, not by their size).
ConformingBody make_conforming_body(const mesh::TetMesh& mesh, particles::Particles particles,
                                    const std::map<int, material::Stiffness>& stiffness, const TraceRule& rule = {});

/// The same body with its vertices elsewhere: stencils, supports and visibility stay as they were, weights follow. `moved` has the
/// tets of the mesh the body was made of.
ConformingBody move_body(const ConformingBody& body, const mesh::TetMesh& moved);

/// Displacement of every face, m.
void face_displacements(const ConformingBody& body, const std::vector<Eigen::Vector3d>& displacement,
                        std::vector<Eigen::Vector3d>& trace);

/// grad u of one particle from the displacements of all faces.
Eigen::Matrix3d face_gradient(const ConformingBody& body, int particle, const std::vector<Eigen::Vector3d>& trace);

/// Gradients smoothed: each the mean over its tet's faces of the gradients' traces (the fits that displacements take, from the tet's own
/// side of an interface). Keeps linear gradients, since the mean of the face centroids is the tet's. A trace's fit scatters by O(h) in
/// the gradient it makes; neighbours' scatter averages out.
std::vector<Eigen::Matrix3d> smoothed_gradients(const ConformingBody& body, const std::vector<Eigen::Matrix3d>& gradient);

/// Strain, stress and energy of given gradients.
Fields fields_of_gradients(const ConformingBody& body, std::vector<Eigen::Matrix3d> gradient);

/// The operator by particles, (grad u)_i = sum_k u_k (x) b_ik, its own entry b_ii included (the b_ik of an i sum to zero).
struct GradientStencils {
    std::vector<std::size_t> offset;
    std::vector<int> index;               ///< ascending within a particle
    std::vector<Eigen::Vector3d> weight;  ///< 1/m
};
GradientStencils gradient_stencils(const ConformingBody& body);

/// `conforming` as one of the strain operators (strain_operator.hpp): d_ij = b_ij for j != i.
StrainOperator conforming_operator(const ConformingBody& body);

}  // namespace cleave::elasticity
