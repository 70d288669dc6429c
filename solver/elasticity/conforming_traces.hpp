#pragma once

#include "solver/elasticity/conforming_faces.hpp"
#include "solver/elasticity/strain.hpp"
#include "solver/particles/particles.hpp"

#include <cstddef>
#include <vector>

namespace cleave::elasticity {

/// How the displacement at a face is fitted: moving least squares about the face's centroid over the particles it can see.
struct TraceRule {
    double support_ratio = 1.6;    ///< support radius in local spacings, mean of the two sides
    double least_moment = 1e-3;    ///< of the scaled moment matrix: smallest singular value over the largest
    double most_weight = 3;        ///< sum |phi|
    double growth = 1.15;          ///< of the support, per round, where a fit misses these two
    int rounds = 16;
    int order = 1;                 ///< 1: exact for linear fields. 0 (Shepard) fails the patch test: for tests
    bool split_interfaces = true;  ///< false: one fit across a material interface, wrong beside it at any size: for tests
};

struct TraceReport {
    int faces = 0;
    int grown = 0;       ///< fits whose support was enlarged or shaped like the cells, which satisfies the rule
    int best_tried = 0;  ///< fits that no support satisfies (a piece of fewer than four particles): the smallest sum |phi| tried
};

/// One fit: who is asked for the displacement of a face. A face between two materials has two, one from either side.
struct Fit {
    int face;
    double share;             ///< of the face's trace: 1, or 1/2 at an interface
    Eigen::Matrix3d tensor;   ///< 1/m, kernel of the fit
    std::vector<int> seen;    ///< particles, ascending
};

struct TraceStencils {
    std::vector<Fit> fits;  ///< by face
    int order = 1;
    TraceReport report;
};

/// Chooses the particles of every fit: those in the support that the face's centroid sees. A particle is seen where the straight
/// segment to it crosses no wall: no boundary face (outer surface or lip of a crack) and no interface between materials. From a face
/// that is a wall itself, only the side of its own particle counts. The support grows until the rule is satisfied; where no size does, one
/// of the shape of the tets beside the face grows likewise.
TraceStencils choose_stencils(const particles::Particles& particles, const FaceSet& faces, const mesh::TetMesh& mesh,
                              const std::vector<int>& material, const TraceRule& rule = {});

/// u_f = sum_k phi_fk u_k for all faces, compressed by face, and the same compressed by particle.
struct TraceWeights {
    std::vector<std::size_t> offset;
    std::vector<int> particle;
    std::vector<double> weight;
    std::vector<std::size_t> transposed_offset;
    std::vector<int> face;
    std::vector<double> transposed_weight;
};

/// The weights of given stencils for particles and faces where they are now.
TraceWeights trace_weights(const TraceStencils& stencils, const particles::Particles& particles, const FaceSet& faces);

}  // namespace cleave::elasticity
