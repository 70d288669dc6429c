#include "validation/test/robustness/random_cuts.hpp"

#include "solver/mesh/tet_mesh.hpp"
#include "solver/subdivision/subdivision_engine.hpp"
#include "solver/subdivision/test/random.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace cleave::robustness {

namespace {

using Eigen::Vector3d;
using subdivision::test::Random;

constexpr int tets_per_batch = 2000, planes_per_batch = 25;
constexpr double flattest = 1e-6;

/// Tets that share nothing. Of a sliver the last corner lies 10^-1 to 10^-6 above its face.
mesh::TetMesh loose_tets(Random& random) {
    mesh::TetMesh mesh;
    while (static_cast<int>(mesh.tets.size()) < tets_per_batch) {
        std::array<Vector3d, 4> corners;
        for (Vector3d& corner : corners) corner = random.in_cube(-1, 1);
        if (mesh.tets.size() % 10 == 0) {
            const double s = random.uniform(0.1, 0.4), t = random.uniform(0.1, 0.4), height = std::pow(10.0, random.uniform(std::log10(flattest), -1));
            corners[3] = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]) + height * random.direction();
        }
        const double volume = mesh::signed_volume(corners[0], corners[1], corners[2], corners[3]);
        if (std::abs(volume) < 0.01 * flattest) continue;
        if (volume < 0) std::swap(corners[0], corners[1]);
        const int first = static_cast<int>(mesh.vertices.size());
        mesh.tets.push_back({first, first + 1, first + 2, first + 3});
        mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    }
    mesh.regions.assign(mesh.tets.size(), 0);
    return mesh;
}

double longest_edge(const mesh::TetMesh& mesh, int tet) {
    double longest = 0;
    for (const int a : mesh.tets[static_cast<std::size_t>(tet)])
        for (const int b : mesh.tets[static_cast<std::size_t>(tet)]) longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
    return longest;
}

/// The children of one engine, with these volumes and points, against their parents.
void count(const mesh::TetMesh& mesh, const subdivision::SubdivisionEngine& engine, std::span<const double> volumes,
           std::span<const std::array<double, 3>> points, CutTally& tally) {
    const auto corner = [&](int vertex) -> Vector3d {
        const int original = static_cast<int>(mesh.vertices.size());
        if (vertex < original) return mesh.vertices[static_cast<std::size_t>(vertex)];
        return Vector3d(points[static_cast<std::size_t>(vertex - original)].data());
    };
    for (std::size_t child = 0; child < volumes.size();) {
        const int parent = engine.child_parents()[child];
        const double whole = mesh::tet_volume(mesh, parent), cube = std::pow(longest_edge(mesh, parent), 3);
        double stated = 0, of_corners = 0;
        for (; child < volumes.size() && engine.child_parents()[child] == parent; ++child, ++tally.children) {
            const auto& [a, b, c, d] = engine.child_tets()[child];
            const double volume = mesh::signed_volume(corner(a), corner(b), corner(c), corner(d));
            stated += volumes[child], of_corners += volume;
            if (!(volumes[child] > 0) || !(volume > 0)) ++tally.negative;
            tally.worst_stated = std::max(tally.worst_stated, std::abs(volumes[child] - volume) / cube);
            tally.smallest_share = std::min(tally.smallest_share, volumes[child] / whole);
        }
        tally.worst_sum = std::max({tally.worst_sum, std::abs(stated - whole) / cube, std::abs(of_corners - whole) / cube});
        ++tally.cuts;
    }
}

}  // namespace

CutTally cut_at_random(long cuts, unsigned seed, const Damage& damage) {
    Random random(seed);
    CutTally tally;
    while (tally.cuts < cuts) {
        const mesh::TetMesh mesh = loose_tets(random);
        subdivision::SubdivisionEngine engine(mesh);
        for (int plane = 0; plane < planes_per_batch && tally.cuts < cuts; ++plane) {
            engine.reset();
            engine.cut(random.plane(-0.5, 0.5));
            if (!damage) {
                count(mesh, engine, engine.child_volumes(), engine.points(), tally);
                continue;
            }
            std::vector<double> volumes(engine.child_volumes().begin(), engine.child_volumes().end());
            std::vector<std::array<double, 3>> points(engine.points().begin(), engine.points().end());
            damage(volumes, points);
            count(mesh, engine, volumes, points, tally);
        }
    }
    return tally;
}

}  // namespace cleave::robustness
