#include "solver/elasticity/conforming_traces.hpp"

#include "solver/elasticity/conforming_walls.hpp"
#include "solver/elasticity/equilibrium_parallel.hpp"
#include "solver/particles/nearest.hpp"
#include "solver/particles/smoothing_tensor.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace cleave::elasticity {

namespace {

/// Directions with less of the scatter matrix than this part of its largest eigenvalue are not spanned.
constexpr double spanned = 1e-12;
/// Fits nearer to each other, or to a limit of the rule, than this part count as equal. On a lattice they are: two layers extrapolate with
/// |2| + |-1| = 3, the limit itself, and which fit is taken must not hang on rounding, nor by it on the particles' numbers.
using particles::alike;

/// The spiky kernel's shape (Eq. 4); its factor cancels in a fit.
double bell(double q) { return q < 1 ? (1 - q) * (1 - q) * (1 - q) : 0; }

struct Weighed {
    std::vector<double> phi;
    double least_moment = 0;  ///< smallest over largest singular value
    double sum = 0;           ///< of |phi|
};

/// Kernel weights w_k = V_k W, normalised to sum one: Shepard's fit, exact for constants only.
Weighed kernel_weights(const particles::Particles& particles, const Eigen::Vector3d& x, const Eigen::Matrix3d& tensor,
                       const std::vector<int>& seen) {
    Weighed result;
    double total = 0;
    for (const int k : seen) {
        result.phi.push_back(particles.volume[k] * bell((tensor * (particles.position[k] - x)).norm()));
        total += result.phi.back();
    }
    if (!(total > 0)) return result;
    for (double& weight : result.phi) weight /= total;
    result.least_moment = result.sum = 1;
    return result;
}

/// Smallest over largest eigenvalue of the scaled moment matrix M = sum w p p^T, p = (1, r), from the mean of r and its scatter.
double moment_ratio(const Eigen::Vector3d& mean, const Eigen::Matrix3d& scatter) {
    Eigen::Matrix4d moment;
    moment << 1, mean.transpose(), mean, scatter + mean * mean.transpose();
    const Eigen::Vector4d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(moment, Eigen::EigenvaluesOnly).eigenvalues();
    return std::max(values(0), 0.0) / values(3);
}

/// Inverse of a scatter matrix on the directions it spans.
Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& scatter) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
    Eigen::Vector3d reciprocal = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (eigen.eigenvalues()(k) > spanned * std::max(eigen.eigenvalues()(2), spanned)) reciprocal(k) = 1 / eigen.eigenvalues()(k);
    return eigen.eigenvectors() * reciprocal.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Moving least squares of order 1 at x, r_k = G (x_k - x), written about the weighted mean m of the r_k with their scatter S:
/// phi_k = w_k (1 - m . S^-1 (r_k - m)). The same as w_k p_k^T M^-1 p(x) with p = (1, r), and exact for constants even where the r_k lie in
/// a plane and S has a pseudo-inverse only.
Weighed weigh(const particles::Particles& particles, const Eigen::Vector3d& x, const Eigen::Matrix3d& tensor, const std::vector<int>& seen,
              int order) {
    Weighed result = kernel_weights(particles, x, tensor, seen);
    if (order == 0 || result.least_moment == 0) return result;
    std::vector<Eigen::Vector3d> r(seen.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < seen.size(); ++n) {
        r[n] = tensor * (particles.position[seen[n]] - x);
        mean += result.phi[n] * r[n];
    }
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < seen.size(); ++n) scatter += result.phi[n] * (r[n] - mean) * (r[n] - mean).transpose();
    const Eigen::Vector3d slope = pseudo_inverse(scatter) * mean;
    result.least_moment = moment_ratio(mean, scatter);
    result.sum = 0;
    for (std::size_t n = 0; n < seen.size(); ++n) {
        result.phi[n] *= 1 - slope.dot(r[n] - mean);
        result.sum += std::abs(result.phi[n]);
    }
    return result;
}

/// What every fit of a body shares.
struct Scene {
    const particles::Particles& particles;
    const mesh::TetMesh& mesh;
    const FaceSet& faces;
    const std::vector<int>& material;
    const TraceRule& rule;
    std::vector<char> opaque;
    Walls walls;
    BoxTree points;
};

std::vector<Box> point_boxes(const particles::Particles& particles) {
    std::vector<Box> boxes;
    for (const Eigen::Vector3d& x : particles.position) boxes.emplace_back(x, x);
    return boxes;
}

std::vector<char> opaque_faces(const FaceSet& faces, const std::vector<int>& material, const TraceRule& rule) {
    std::vector<char> opaque;
    for (const Face& face : faces.faces)
        opaque.push_back(face.is_boundary() || (rule.split_interfaces && material[face.inside] != material[face.outside]));
    return opaque;
}

/// Kernel of a fit: the mean shape of the particles beside the face, at the mean support.
Eigen::Matrix3d fit_tensor(const Scene& scene, const Face& face) {
    const auto unit = [&](int i) -> Eigen::Matrix3d { return scene.particles.tensor[i] * scene.particles.support_radius[i]; };
    const int i = face.inside, j = face.is_boundary() ? i : face.outside;
    const double spacing = 0.5 * (scene.particles.spacing[i] + scene.particles.spacing[j]);
    return 0.5 * (unit(i) + unit(j)) / (scene.rule.support_ratio * spacing);
}

/// Kernel of the shape of the tets beside the face, as large as fit_tensor: what finds neighbours all round among cells far longer than wide.
Eigen::Matrix3d cell_tensor(const Scene& scene, const Face& face) {
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const int tet : {face.inside, face.is_boundary() ? face.inside : face.outside})
        for (const int vertex : scene.mesh.tets[tet]) {
            const Eigen::Vector3d r = scene.mesh.vertices[vertex] - mesh::tet_centroid(scene.mesh, tet);
            moment += r * r.transpose();
        }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moment);
    const Eigen::Vector3d axes = eigen.eigenvalues().cwiseMax(spanned * eigen.eigenvalues()(2)).cwiseSqrt();
    const double size = std::cbrt(fit_tensor(scene, face).determinant() * axes.prod());
    return size * eigen.eigenvectors() * axes.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
}

/// Particles in the support that the face sees, from the side of the particle `side` where the face is a wall.
std::vector<int> seen_particles(const Scene& scene, int f, int side, const Eigen::Matrix3d& tensor) {
    const Face& face = scene.faces.faces[f];
    const Eigen::Vector3d half = particles::support_box(tensor);
    const Eigen::Vector3d low = face.centroid - half, high = face.centroid + half;
    const std::vector<int> walls = scene.walls.near(low, high);
    const Eigen::Vector3d away = face.inside == side ? face.area : Eigen::Vector3d(-face.area);
    std::vector<int> seen;
    for (const int j : scene.points.touching(Box(low, high))) {
        const Eigen::Vector3d r = scene.particles.position[j] - face.centroid;
        if ((tensor * r).norm() >= 1) continue;
        if (scene.rule.split_interfaces && scene.material[j] != scene.material[side]) continue;
        if (scene.opaque[f] && away.dot(r) >= 0) continue;
        if (scene.walls.visible(face.centroid, scene.particles.position[j], walls)) seen.push_back(j);
    }
    return seen;
}

enum class Outcome { as_is, grown, best_tried };

struct Chosen {
    Fit fit;
    Outcome outcome;
};

/// A face, and the particle from whose side it is fitted.
struct Place {
    int face, side;
    double share;
};

/// The particle beside the face alone, under a kernel that holds it: the last resort, exact for constants.
Fit own_particle(const Scene& scene, const Place& place) {
    const Eigen::Matrix3d tensor = fit_tensor(scene, scene.faces.faces[place.face]);
    const double q = (tensor * (scene.particles.position[place.side] - scene.faces.faces[place.face].centroid)).norm();
    return {place.face, place.share, tensor / (2 * std::max(q, 1.0)), {place.side}};
}

/// The best fit found so far that does not satisfy the rule.
struct BestFit {
    Fit fit;
    double sum = std::numeric_limits<double>::infinity(), moment = 0;

    /// A fit that spans space beats one that does not; among those that do, the smaller sum.
    void offer(const Fit& other, double other_moment, double other_sum) {
        if (other_moment < spanned) other_moment = 0;
        const bool less = other_moment < (1 - alike) * moment, more = other_moment > (1 + alike) * moment;
        if (other.seen.empty() || less || (!more && !(other_sum < (1 - alike) * sum))) return;
        fit = other, moment = other_moment, sum = other_sum;
    }
};

/// Lets the kernel `tensor` grow until the rule is satisfied; none where no size does, which leaves the best in `best`.
std::optional<Chosen> grown_fit(const Scene& scene, const Place& place, const Eigen::Matrix3d& tensor, BestFit& best) {
    Fit fit{place.face, place.share, tensor, {}};
    for (int round = 0; round <= scene.rule.rounds; ++round, fit.tensor /= scene.rule.growth) {
        fit.seen = seen_particles(scene, place.face, place.side, fit.tensor);
        const Weighed weighed = weigh(scene.particles, scene.faces.faces[place.face].centroid, fit.tensor, fit.seen, scene.rule.order);
        const bool spans = weighed.least_moment >= (1 - alike) * scene.rule.least_moment;
        if (spans && weighed.sum <= (1 + alike) * scene.rule.most_weight) return Chosen{std::move(fit), round == 0 ? Outcome::as_is : Outcome::grown};
        best.offer(fit, spans ? 1 : weighed.least_moment, weighed.sum);
    }
    return std::nullopt;
}

Chosen choose_fit(const Scene& scene, const Place& place) {
    const Face& face = scene.faces.faces[place.face];
    BestFit best{own_particle(scene, place)};
    if (auto fit = grown_fit(scene, place, fit_tensor(scene, face), best)) return std::move(*fit);
    if (auto fit = grown_fit(scene, place, cell_tensor(scene, face), best)) return {std::move(fit->fit), Outcome::grown};
    return {std::move(best.fit), Outcome::best_tried};
}

/// One fit per face, or one from either side of an interface.
std::vector<Place> list_places(const Scene& scene) {
    std::vector<Place> places;
    for (int f = 0; f < scene.faces.size(); ++f) {
        const Face& face = scene.faces.faces[f];
        const bool interface = scene.opaque[f] && !face.is_boundary();
        places.push_back({f, face.inside, interface ? 0.5 : 1.0});
        if (interface) places.push_back({f, face.outside, 0.5});
    }
    return places;
}

void transpose(TraceWeights& weights, int particles) {
    weights.transposed_offset.assign(particles + 1, 0);
    for (const int k : weights.particle) ++weights.transposed_offset[k + 1];
    std::partial_sum(weights.transposed_offset.begin(), weights.transposed_offset.end(), weights.transposed_offset.begin());
    weights.face.resize(weights.particle.size());
    weights.transposed_weight.resize(weights.particle.size());
    std::vector<std::size_t> next(weights.transposed_offset.begin(), weights.transposed_offset.end() - 1);
    for (int f = 0; f + 1 < static_cast<int>(weights.offset.size()); ++f)
        for (std::size_t n = weights.offset[f]; n < weights.offset[f + 1]; ++n) {
            const std::size_t at = next[weights.particle[n]]++;
            weights.face[at] = f;
            weights.transposed_weight[at] = weights.weight[n];
        }
}

}  // namespace

TraceStencils choose_stencils(const particles::Particles& particles, const FaceSet& faces, const mesh::TetMesh& mesh,
                              const std::vector<int>& material, const TraceRule& rule) {
    const std::vector<char> opaque = opaque_faces(faces, material, rule);
    const Scene scene{particles, mesh, faces, material, rule, opaque, Walls(mesh, faces, opaque), BoxTree(point_boxes(particles))};
    const std::vector<Place> places = list_places(scene);
    TraceStencils stencils{std::vector<Fit>(places.size()), rule.order, {faces.size(), 0, 0}};
    std::vector<Outcome> outcome(places.size());
    parallel_for_each(static_cast<int>(places.size()), [&](int n) {
        Chosen chosen = choose_fit(scene, places[n]);
        stencils.fits[n] = std::move(chosen.fit);
        outcome[n] = chosen.outcome;
    });
    for (const Outcome of : outcome) {
        stencils.report.grown += of == Outcome::grown;
        stencils.report.best_tried += of == Outcome::best_tried;
    }
    return stencils;
}

TraceWeights trace_weights(const TraceStencils& stencils, const particles::Particles& particles, const FaceSet& faces) {
    const int count = static_cast<int>(stencils.fits.size());
    std::vector<std::size_t> first(count + 1, 0);
    for (int n = 0; n < count; ++n) first[n + 1] = first[n] + stencils.fits[n].seen.size();
    TraceWeights weights;
    weights.offset.assign(faces.size() + 1, 0);
    for (int n = 0; n < count; ++n) weights.offset[stencils.fits[n].face + 1] = first[n + 1];
    weights.particle.resize(first.back());
    weights.weight.resize(first.back());
    parallel_for_each(count, [&](int n) {
        const Fit& fit = stencils.fits[n];
        const Weighed weighed = weigh(particles, faces.faces[fit.face].centroid, fit.tensor, fit.seen, stencils.order);
        for (std::size_t k = 0; k < fit.seen.size(); ++k) {
            weights.particle[first[n] + k] = fit.seen[k];
            weights.weight[first[n] + k] = fit.share * weighed.phi[k];
        }
    });
    transpose(weights, particles.size());
    return weights;
}

}  // namespace cleave::elasticity
