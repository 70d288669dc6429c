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

/// Finds the sets of linked particles among those given, all of a fragment.
void FragmentedBody::unite(const std::vector<int>& particles) {
    const int fragment = fragment_of_[static_cast<std::size_t>(particles.front())];
    sets_.find(engine_, links_, particles, [&](int particle) { return fragment_of_[static_cast<std::size_t>(particle)] == fragment; });
}

/// Numbers new fragments by their smallest particles. Particles of one set come in long rows, which are returned: they are handed on whole.
std::vector<FragmentedBody::Row> FragmentedBody::number_sets(const std::vector<int>& particles) {
    std::vector<Row> rows;
    int last_root = -1, number = -1, next = fragments();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const int particle = particles[i], root = sets_.look_up(particle);  // the smallest of its set: it came first
        if (root != last_root) {
            number = root == particle ? next++ : fragment_of_[root];
            rows.push_back({i, i, number});
            last_root = root;
        }
        rows.back().last = i + 1;
        fragment_of_[particle] = number;
    }
    return rows;
}

/// Hands the particles to new fragments where they form several sets (returned), back to the fragment where they form one.
std::vector<int> FragmentedBody::split(int fragment, std::vector<int> particles) {
    std::vector<int> numbers;
    if (std::all_of(particles.begin(), particles.end(), [&](int particle) { return sets_.look_up(particle) == particles.front(); })) {
        fragments_[fragment].particles = std::move(particles);
        return numbers;
    }
    const std::vector<Row> rows = number_sets(particles);
    std::vector<std::size_t> sizes;
    for (const Row& row : rows) {
        const auto set = static_cast<std::size_t>(row.fragment - fragments());
        if (set == sizes.size()) sizes.push_back(0);
        sizes[set] += row.last - row.first;
    }
    for (const std::size_t size : sizes) {
        numbers.push_back(fragments());
        fragments_.push_back({.origin = fragment, .retired = false, .particles = {}});
        fragments_.back().particles.reserve(size);
    }
    for (const Row& row : rows) {
        std::vector<int>& members = fragments_[row.fragment].particles;
        members.insert(members.end(), particles.data() + row.first, particles.data() + row.last);
    }
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
