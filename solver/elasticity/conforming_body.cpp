#include "solver/elasticity/conforming_body.hpp"

#include "solver/elasticity/equilibrium_parallel.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cleave::elasticity {

namespace {

void place_particles(particles::Particles& particles, const mesh::TetMesh& mesh) {
    for (int i = 0; i < particles.size(); ++i) {
        particles.position[i] = mesh::tet_centroid(mesh, i);
        particles.volume[i] = mesh::tet_volume(mesh, i);
        if (!(particles.volume[i] > 0)) throw std::invalid_argument("a moved tet of positive volume (tet " + std::to_string(i + 1) + ")");
    }
}

/// b_ik of one particle, by ascending k: (1/V_i) sum_f phi_fk A_f n_f.
std::vector<std::pair<int, Eigen::Vector3d>> particle_stencil(const ConformingBody& body, int i) {
    std::vector<std::pair<int, Eigen::Vector3d>> entries;
    for (int k = 0; k < 4; ++k) {
        const int f = body.faces.of_half_face[4 * i + k];
        const Face& face = body.faces.faces[f];
        const Eigen::Vector3d area = (face.inside == i ? 1 : -1) / body.particles.volume[i] * face.area;
        for (std::size_t n = body.traces.offset[f]; n < body.traces.offset[f + 1]; ++n)
            entries.emplace_back(body.traces.particle[n], body.traces.weight[n] * area);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t last = 0;
    for (std::size_t n = 1; n < entries.size(); ++n) {
        if (entries[n].first == entries[last].first) entries[last].second += entries[n].second;
        else entries[++last] = entries[n];
    }
    entries.resize(last + 1);
    return entries;
}

}  // namespace

Solid solid_of_regions(const std::vector<int>& region, const std::map<int, material::Stiffness>& stiffness) {
    Solid solid;
    std::map<int, int> number;
    for (const auto& [id, matrix] : stiffness) {
        const auto same = std::find(solid.stiffness.begin(), solid.stiffness.end(), matrix);
        number[id] = static_cast<int>(same - solid.stiffness.begin());
        if (same == solid.stiffness.end()) solid.stiffness.push_back(matrix);
    }
    for (const int id : region) {
        const auto found = number.find(id);
        if (found == number.end()) throw std::invalid_argument("a stiffness for region " + std::to_string(id));
        solid.material.push_back(found->second);
    }
    return solid;
}

ConformingBody make_conforming_body(const mesh::TetMesh& mesh, const std::map<int, material::Stiffness>& stiffness,
                                    const TraceRule& rule) {
    return make_conforming_body(mesh, particles::from_mesh(mesh), stiffness, rule);
}

ConformingBody make_conforming_body(const mesh::TetMesh& mesh, particles::Particles particles,
                                    const std::map<int, material::Stiffness>& stiffness, const TraceRule& rule) {
    ConformingBody body{std::move(particles), collect_faces(mesh), {}, {}, {}};
    body.solid = solid_of_regions(body.particles.region, stiffness);
    body.stencils = choose_stencils(body.particles, body.faces, mesh, body.solid.material, rule);
    body.traces = trace_weights(body.stencils, body.particles, body.faces);
    return body;
}

ConformingBody move_body(const ConformingBody& body, const mesh::TetMesh& moved) {
    ConformingBody result = body;
    place_particles(result.particles, moved);
    result.faces = collect_faces(moved);
    result.traces = trace_weights(result.stencils, result.particles, result.faces);
    return result;
}

void face_displacements(const ConformingBody& body, const std::vector<Eigen::Vector3d>& displacement,
                        std::vector<Eigen::Vector3d>& trace) {
    trace.resize(body.faces.faces.size());
    parallel_for_each(body.faces.size(), [&](int f) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t n = body.traces.offset[f]; n < body.traces.offset[f + 1]; ++n)
            sum += body.traces.weight[n] * displacement[body.traces.particle[n]];
        trace[f] = sum;
    });
}

Eigen::Matrix3d face_gradient(const ConformingBody& body, int particle, const std::vector<Eigen::Vector3d>& trace) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 4; ++k) {
        const int f = body.faces.of_half_face[4 * particle + k];
        const Face& face = body.faces.faces[f];
        if (face.inside == particle) sum += trace[f] * face.area.transpose();
        else sum -= trace[f] * face.area.transpose();
    }
    return sum / body.particles.volume[particle];
}

std::vector<Eigen::Matrix3d> smoothed_gradients(const ConformingBody& body, const std::vector<Eigen::Matrix3d>& gradient) {
    std::vector<Eigen::Matrix3d> smoothed(gradient.size());
    const std::vector<int>& material = body.solid.material;
    parallel_for_each(body.particles.size(), [&](int i) {
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (int k = 0; k < 4; ++k) {
            const int f = body.faces.of_half_face[4 * i + k];
            const Face& face = body.faces.faces[f];
            const bool interface = !face.is_boundary() && material[face.inside] != material[face.outside];
            for (std::size_t n = body.traces.offset[f]; n < body.traces.offset[f + 1]; ++n) {
                const int j = body.traces.particle[n];
                // An interface's trace is the mean of two fits, told apart by their particles' material: twice the own half.
                if (interface && material[j] != material[i]) continue;
                sum += (interface ? 0.5 : 0.25) * body.traces.weight[n] * gradient[j];
            }
        }
        smoothed[i] = sum;
    });
    return smoothed;
}

Fields fields_of_gradients(const ConformingBody& body, std::vector<Eigen::Matrix3d> gradient) {
    const std::size_t count = gradient.size();
    Fields fields{std::move(gradient), std::vector<material::Voigt>(count), std::vector<material::Voigt>(count),
                  std::vector<double>(count)};
    parallel_for_each(static_cast<int>(count), [&](int i) {
        fields.strain[i] = strain_of(fields.gradient[i]);
        fields.stress[i] = body.solid.of(i) * fields.strain[i];
        fields.energy[i] = strain_energy(body.particles.volume[i], fields.strain[i], fields.stress[i]);
    });
    return fields;
}

GradientStencils gradient_stencils(const ConformingBody& body) {
    GradientStencils stencils;
    stencils.offset.push_back(0);
    for (int i = 0; i < body.particles.size(); ++i) {
        for (const auto& [k, weight] : particle_stencil(body, i)) {
            stencils.index.push_back(k);
            stencils.weight.push_back(weight);
        }
        stencils.offset.push_back(stencils.index.size());
    }
    return stencils;
}

StrainOperator conforming_operator(const ConformingBody& body) {
    const GradientStencils stencils = gradient_stencils(body);
    StrainOperator op;
    op.name = "conforming";
    op.neighbours.offset.push_back(0);
    for (int i = 0; i < body.particles.size(); ++i) {
        for (std::size_t n = stencils.offset[i]; n < stencils.offset[i + 1]; ++n) {
            if (stencils.index[n] == i) continue;
            op.neighbours.index.push_back(stencils.index[n]);
            op.weight.push_back(stencils.weight[n]);
        }
        op.neighbours.offset.push_back(op.neighbours.index.size());
    }
    op.report.particles = body.particles.size();
    op.report.raised_supports = body.stencils.report.grown;
    op.report.poor_supports = body.stencils.report.best_tried;
    return op;
}

}  // namespace cleave::elasticity
