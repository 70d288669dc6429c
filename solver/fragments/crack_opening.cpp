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

/// Links over equal faces between these particles; those in blocks of tets beside the plane are not looked at.
int CrackOpening::open_faces(LinkTable& links, const std::vector<int>& particles) const {
    if (particles.empty()) return 0;
    const LinkBlocks& blocks = links.blocks();
    std::vector<std::uint8_t> beside(static_cast<std::size_t>(particles.back() / LinkBlocks::size) + 1, 0);
    for (int block = 0; block < std::min(blocks.blocks(), static_cast<int>(beside.size())); ++block) {
        beside[static_cast<std::size_t>(block)] = blocks.is_beside(block, crack_.disc);
    }
    const auto is_beside = [&](int particle) { return beside[static_cast<std::size_t>(particle / LinkBlocks::size)] != 0; };
    std::vector<int> near;
    for (const int particle : particles) {
        if (!is_beside(particle)) near.push_back(particle);
    }
    const int first = particles.front(), last = particles.back();
    std::vector<std::int8_t> sides(static_cast<std::size_t>(last - first + 1), 0);  // 0: beside the plane, or not one of these
    std::vector<std::array<int, 2>> found;
    int own_side = 0;
    links.for_each_link(engine_, near, [&](int particle) { sides[particle - first] = static_cast<std::int8_t>(own_side = side(particle)); },
                        [&](int particle, int neighbour) {
                            return neighbour >= first && neighbour <= last && (neighbour < particle || is_beside(neighbour));
                        },
                        [&](int particle, int neighbour) {
                            const int other_side = is_beside(neighbour) ? side(neighbour) : sides[neighbour - first];
                            if (other_side == -own_side) found.push_back({particle, neighbour});
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
