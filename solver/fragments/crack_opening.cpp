#include "solver/fragments/crack_opening.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cleave::fragments {

using Eigen::Vector3d;

CrackOpening::CrackOpening(const FragmentedBody& body, const Crack& crack, const std::vector<int>& particles)
    : body_(body), engine_(body.engine()), crack_(crack), particles_(particles),
      fragment_(particles.empty() ? -1 : body.fragment_of(particles.front())) {}

/// A child of this cut lies where the cut left it (the vertex rule tau may move that off the plane); others by their centroid.
int CrackOpening::side(int particle) const {
    const int child = particle - body_.originals();
    if (body_.scheme() == Scheme::adaptive && child >= engine_.first_new_child()) return engine_.side(child);
    return subdivision::plane_distance(crack_.disc.normal, crack_.disc.centre, body_.centroid(particle)) >= 0 ? 1 : -1;
}

/// The line between the centroids meets the plane at a + |d_a| / (|d_a| + |d_b|) (b - a).
bool CrackOpening::meets_disc(int first, int second) const {
    if (!breaks(first) || !breaks(second)) return false;
    if (std::isinf(crack_.disc.radius)) return true;
    const Vector3d a = body_.centroid(first), b = body_.centroid(second);
    const double da = std::abs(subdivision::plane_distance(crack_.disc.normal, crack_.disc.centre, a));
    const double db = std::abs(subdivision::plane_distance(crack_.disc.normal, crack_.disc.centre, b));
    const double along = da + db > 0 ? da / (da + db) : 0.5;
    return (a + along * (b - a) - crack_.disc.centre).norm() <= crack_.disc.radius;
}

/// Links inside the tets that this cut divided, and from their bases to older children. (Equal pieces at a face between two tets
/// of this cut lie on the same side.)
int CrackOpening::open_new_parents(LinkTable& links) const {
    const int new_children = body_.originals() + engine_.first_new_child();
    int removed = 0;
    for (const int parent : engine_.last_parents()) {
        const subdivision::PieceTable& pieces = engine_.pieces(parent);
        const int first = body_.originals() + engine_.first_child(parent);
        for (int half_face = 0; half_face < 4 * pieces.children; ++half_face) {
            const int here = half_face / 4, inner = pieces.inner[here][half_face % 4];
            const int behind = inner >= 0 ? 4 * first + inner : links.opposite(engine_, 4 * first + half_face);
            const bool candidate = inner >= 0 ? inner > half_face && pieces.side[here] != pieces.side[inner / 4]
                                              : behind >= 0 && behind < 4 * new_children && !links.is_removed(behind);
            if (!candidate || !intersects(first + here, behind / 4)) continue;
            links.remove(engine_, behind);
            ++removed;
        }
    }
    return removed;
}

/// The corners of originals lie scattered in memory: asks for those of a particle further on.
void CrackOpening::prefetch_near(const std::vector<int>& near, std::size_t i) const {
    constexpr std::size_t ahead = 8;
    const mesh::TetMesh& mesh = body_.original();
    if (i + 2 * ahead < near.size() && near[i + 2 * ahead] < body_.originals()) __builtin_prefetch(&mesh.tets[near[i + 2 * ahead]]);
    if (i + ahead >= near.size() || near[i + ahead] >= body_.originals()) return;
    for (const int vertex : mesh.tets[near[i + ahead]]) __builtin_prefetch(&mesh.vertices[vertex]);
}

/// Those that are not in a box of tets on one side.
std::vector<int> CrackOpening::particles_near(std::span<const int> particles, const std::vector<std::int8_t>& box_sides) const {
    constexpr std::size_t box_size = LinkBlocks::box_size;
    std::vector<int> near;
    for (std::size_t i = 0; i < particles.size();) {
        const auto particle = static_cast<std::size_t>(particles[i]);
        const bool is_near = box_sides[particle / box_size] == 0;
        if (is_near) near.push_back(particles[i]);
        const std::size_t next = i + box_size;
        const bool has_box = particle % box_size == 0 && next < particles.size() && particles[next] == particles[i] + LinkBlocks::box_size;
        i = has_box && !is_near ? next : i + 1;
    }
    return near;
}

/// Links over equal faces between these particles; those in boxes of tets beside the plane are not looked at.
int CrackOpening::open_faces(LinkTable& links, std::span<const int> particles) const {
    if (particles.empty()) return 0;
    constexpr int box_size = LinkBlocks::box_size;
    const LinkBlocks& blocks = links.blocks();
    std::vector<std::int8_t> box_sides(static_cast<std::size_t>(particles.back() / box_size) + 1, 0);  // 0: the plane passes near
    for (int box = particles.front() / box_size; box < std::min(blocks.boxes(), static_cast<int>(box_sides.size())); ++box) {
        box_sides[static_cast<std::size_t>(box)] = static_cast<std::int8_t>(blocks.side(box, crack_.disc));
    }
    const auto box_side = [&](int particle) -> int { return box_sides[static_cast<std::size_t>(particle / box_size)]; };
    const std::vector<int> near = particles_near(particles, box_sides);
    const int first = particles.front(), last = particles.back();
    std::vector<std::int8_t> sides(static_cast<std::size_t>(last - first + 1), 0);  // 0: beside the plane, or not one of these
    for (std::size_t i = 0; i < near.size(); ++i) {
        prefetch_near(near, i);
        sides[near[i] - first] = static_cast<std::int8_t>(side(near[i]));
    }
    std::vector<std::array<int, 2>> found;
    links.for_each_link(engine_, near, [](int) {},
                        [&](int particle, int neighbour) {
                            return neighbour >= first && neighbour <= last && (neighbour < particle || box_side(neighbour) != 0);
                        },
                        [&](int particle, int neighbour) {
                            if (box_side(neighbour) + sides[neighbour - first] == -sides[particle - first]) found.push_back({particle, neighbour});
                        });
    int removed = 0;
    for (const auto& [particle, neighbour] : found) {
        if (!meets_disc(particle, neighbour)) continue;
        for (int face = 0; face < 4; ++face) {
            const int behind = links.opposite(engine_, 4 * particle + face);
            if (behind >= 0 && behind / 4 == neighbour) links.remove(engine_, 4 * particle + face);
        }
        ++removed;
    }
    return removed;
}

int CrackOpening::open_partial(LinkTable& links) const {
    int removed = 0;
    for (std::size_t i = 0; i < links.partial().size(); ++i) {
        const auto& [link, gone] = links.partial()[i];
        if (gone || !is_ours(link.first / 4) || !intersects(link.first / 4, link.second / 4)) continue;
        links.remove_partial(i);
        ++removed;
    }
    return removed;
}

int CrackOpening::remove_intersected(LinkTable& links) const {
    if (body_.scheme() == Scheme::basic) return open_faces(links, particles_);
    const auto old_children = std::lower_bound(particles_.begin(), particles_.end(), body_.originals());
    const auto new_children = std::lower_bound(old_children, particles_.end(), body_.originals() + engine_.first_new_child());
    return open_new_parents(links) + open_faces(links, {old_children, new_children}) + open_partial(links);
}

int CrackOpening::isolate_inside(LinkTable& links) const {
    if (!(crack_.inner_radius > 0)) return 0;
    std::vector<int> inside;
    for (const int particle : particles_) {
        if (breaks(particle) && (body_.centroid(particle) - crack_.disc.centre).norm() < crack_.inner_radius) inside.push_back(particle);
    }
    for (const int particle : inside) {
        for (int face = 0; face < 4; ++face) {
            if (links.opposite(engine_, 4 * particle + face) >= 0) links.remove(engine_, 4 * particle + face);
        }
    }
    const auto is_inside = [&](int half_face) { return std::binary_search(inside.begin(), inside.end(), half_face / 4); };
    for (std::size_t i = 0; i < links.partial().size(); ++i) {
        const subdivision::ExtraLink& link = links.partial()[i].link;
        if (is_inside(link.first) || is_inside(link.second)) links.remove_partial(i);
    }
    return static_cast<int>(inside.size());
}

}  // namespace cleave::fragments
