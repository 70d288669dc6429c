#include "solver/fragments/fragmented_body.hpp"

#include "solver/fragments/crack_opening.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cleave::fragments {

using Eigen::Vector3d;

FragmentedBody::FragmentedBody(const mesh::TetMesh& mesh, Scheme scheme, const subdivision::Options& options)
    : mesh_(mesh), scheme_(scheme), engine_(mesh, options), links_(engine_) {
    find_first_fragments();
}

void FragmentedBody::reset() {
    engine_.reset();
    links_.reset();
    find_first_fragments();
}

/// The components of the mesh.
void FragmentedBody::find_first_fragments() {
    std::vector<int> all(mesh_.tets.size());
    std::iota(all.begin(), all.end(), 0);
    fragment_of_.assign(mesh_.tets.size(), 0);
    unite(all);
    fragments_.assign(1, {});
    if (split(0, std::move(all)).empty()) return;
    fragments_.erase(fragments_.begin());
    for (Fragment& fragment : fragments_) fragment.origin = -1;
    for (int& number : fragment_of_) --number;
}

/// The crack with a unit normal.
Crack FragmentedBody::valid(const Crack& crack, int fragment) const {
    if (fragment < 0 || fragment >= fragments() || fragments_[fragment].retired) {
        throw std::invalid_argument("FragmentedBody: the fragment does not exist, or fell apart before");
    }
    if (!(crack.inner_radius >= 0) || !std::isfinite(crack.inner_radius)) {
        throw std::invalid_argument("FragmentedBody: the inner radius must be finite and not negative");
    }
    return {.disc = subdivision::checked(crack.disc), .inner_radius = crack.inner_radius, .region = crack.region};
}

CrackOutcome FragmentedBody::crack(const Crack& crack, int fragment) {
    const subdivision::Counts counts = subdivide(crack, fragment);
    CrackOutcome outcome = open(crack, fragment);
    outcome.counts = counts;
    return outcome;
}

subdivision::Counts FragmentedBody::subdivide(const Crack& crack, int fragment) {
    const Crack unit = valid(crack, fragment);
    if (scheme_ == Scheme::basic) return {.uncut = originals()};
    subdivision::Among among{.labels = fragment_of_.data(), .label = fragment};
    if (crack.region && !mesh_.regions.empty()) among.regions = mesh_.regions.data(), among.region = *crack.region;
    const subdivision::Counts counts = engine_.cut(unit.disc, among);
    links_.take_over(engine_);
    for (const int parent : engine_.last_parents()) fragment_of_[parent] = -1;
    std::vector<int>& particles = fragments_[fragment].particles;
    std::erase_if(particles, [&](int particle) { return fragment_of_[particle] < 0; });
    for (int particle = static_cast<int>(fragment_of_.size()); particle < particle_numbers(); ++particle) particles.push_back(particle);
    fragment_of_.resize(particle_numbers(), fragment);
    return counts;
}

CrackOutcome FragmentedBody::open(const Crack& crack, int fragment) {
    const Crack unit = valid(crack, fragment);
    CrackOutcome outcome;
    std::vector<int> particles = std::move(fragments_[fragment].particles);
    const CrackOpening opening(*this, unit, particles);
    outcome.removed_links = opening.remove_intersected(links_);
    outcome.isolated = opening.isolate_inside(links_);
    unite(particles);
    outcome.new_fragments = split(fragment, std::move(particles));
    return outcome;
}

/// Calls in_block(block) for blocks that no crack has touched and whose tets are all among the particles, in_between(particles) for the
/// others, in ascending order.
template <class InBlock, class InBetween>
void FragmentedBody::walk(std::span<const int> particles, const InBlock& in_block, const InBetween& in_between) const {
    constexpr std::size_t size = LinkBlocks::size;
    std::size_t start = 0;  // of the particles between blocks
    for (std::size_t i = 0; i < particles.size();) {
        const int block = particles[i] / LinkBlocks::size;
        const bool whole = block < links_.blocks().blocks() && i + size <= particles.size() && particles[i] % LinkBlocks::size == 0 &&
                           particles[i + size - 1] == particles[i] + LinkBlocks::size - 1 && links_.is_untouched(block);
        if (!whole) {
            ++i;
            continue;
        }
        if (start < i) in_between(particles.subspan(start, i - start));
        in_block(block);
        start = i += size;
    }
    if (start < particles.size()) in_between(particles.subspan(start));
}

/// Finds the sets of linked particles among those given: part by part in blocks that no crack has touched, else one by one.
void FragmentedBody::unite(const std::vector<int>& particles) {
    const LinkBlocks& blocks = links_.blocks();
    sets_.grow(particle_numbers());
    in_parts_.assign(static_cast<std::size_t>(particle_numbers() / LinkBlocks::size) + 1, 0);
    const std::uint8_t* in_parts = in_parts_.data();
    const auto is_in_parts = [in_parts](int particle) { return in_parts[static_cast<unsigned>(particle) / LinkBlocks::size] != 0; };
    walk(particles,
         [&](int block) {
             in_parts_[static_cast<std::size_t>(block)] = 1;
             for (const int part : blocks.parts(block)) sets_.make_single(part);
         },
         [&](std::span<const int> between) {
             for (const int particle : between) sets_.make_single(particle);
         });
    walk(particles,
         [&](int block) {
             for (const auto& [part, other] : blocks.links_down(block)) {
                 if (is_in_parts(other)) sets_.unite(part, other);
             }
         },
         [&](std::span<const int> between) {
             int root = -1;
             links_.for_each_link(engine_, between, [&](int particle) { root = sets_.find(particle); },
                                  [&](int particle, int neighbour) { return (neighbour < particle) | is_in_parts(neighbour); },
                                  [&](int, int neighbour) {
                                      root = sets_.unite_root(root, is_in_parts(neighbour) ? blocks.part_of(neighbour) : neighbour);
                                  });
         });
    const auto set_of = [&](int particle) { return is_in_parts(particle) ? blocks.part_of(particle) : particle; };
    for (const PartialLink& partial : links_.partial()) {
        const int first = partial.link.first / 4, second = partial.link.second / 4;
        if (!partial.removed && fragment_of_[first] == fragment_of_[particles.front()]) sets_.unite(set_of(first), set_of(second));
    }
    walk(particles,
         [&](int block) {
             for (const int part : blocks.parts(block)) sets_.flatten(part);
             const int first = block * LinkBlocks::size;
             if (blocks.parts(block).size() == 1) sets_.follow(first, LinkBlocks::size, first);
             else for (int tet = first; tet < first + LinkBlocks::size; ++tet) sets_.follow(tet, 1, blocks.part_of(tet));
         },
         [&](std::span<const int> between) {
             for (const int particle : between) sets_.flatten(particle);
         });
}

/// Hands the particles to new fragments where they form several sets (returned), back to the fragment where they form one.
std::vector<int> FragmentedBody::split(int fragment, std::vector<int> particles) {
    std::vector<int> numbers;
    if (std::all_of(particles.begin(), particles.end(), [&](int particle) { return sets_.look_up(particle) == particles.front(); })) {
        fragments_[fragment].particles = std::move(particles);
        return numbers;
    }
    const int first_new = fragments();
    std::vector<std::size_t> sizes;
    for (const int particle : particles) {
        const int root = sets_.look_up(particle);  // the smallest of its set: it came first
        if (root == particle) {
            fragment_of_[particle] = first_new + static_cast<int>(sizes.size());
            sizes.push_back(0);
        }
        fragment_of_[particle] = fragment_of_[root];
        ++sizes[fragment_of_[particle] - first_new];
    }
    for (const std::size_t size : sizes) {
        numbers.push_back(fragments());
        fragments_.push_back({.origin = fragment, .retired = false, .particles = {}});
        fragments_.back().particles.reserve(size);
    }
    for (const int particle : particles) fragments_[fragment_of_[particle]].particles.push_back(particle);
    fragments_[fragment].retired = true;
    fragments_[fragment].particles.clear();
    return numbers;
}

int FragmentedBody::particle_numbers() const { return originals() + static_cast<int>(engine_.child_tets().size()); }

bool FragmentedBody::is_particle(int number) const { return number >= 0 && number < particle_numbers() && !links_.is_gone(number); }

std::array<int, 4> FragmentedBody::vertices(int particle) const {
    return particle < originals() ? mesh_.tets[particle] : engine_.child_tets()[particle - originals()];
}

Vector3d FragmentedBody::point(int vertex) const {
    const int made = vertex - static_cast<int>(mesh_.vertices.size());
    return made < 0 ? mesh_.vertices[vertex] : Vector3d::Map(engine_.points()[made].data()).eval();
}

double FragmentedBody::volume(int particle) const {
    return particle < originals() ? mesh::tet_volume(mesh_, particle) : engine_.child_volumes()[particle - originals()];
}

Vector3d FragmentedBody::centroid(int particle) const {
    if (particle < originals()) return mesh::tet_centroid(mesh_, particle);
    return Vector3d::Map(engine_.child_centroids()[particle - originals()].data());
}

int FragmentedBody::parent(int particle) const { return particle < originals() ? particle : engine_.child_parents()[particle - originals()]; }

int FragmentedBody::region(int particle) const {
    return mesh_.regions.empty() ? 0 : mesh_.regions[parent(particle)];
}

std::vector<int> FragmentedBody::current_fragments() const {
    std::vector<int> numbers;
    for (int i = 0; i < fragments(); ++i) {
        if (!fragments_[i].retired) numbers.push_back(i);
    }
    return numbers;
}

}  // namespace cleave::fragments
