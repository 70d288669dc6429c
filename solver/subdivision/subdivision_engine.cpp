#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::subdivision {
namespace {

constexpr std::size_t chunk_size = 256;                ///< parents that one thread takes at a time
constexpr std::size_t together_from = 8 * chunk_size;  ///< parents: fewer are not worth waking threads

}  // namespace

SubdivisionEngine::SubdivisionEngine(const mesh::TetMesh& mesh, const Options& options)
    : tables_(piece_tables().data()), layouts_(parent_layouts().data()), canonical_(mesh), boxes_(canonical_), original_(mesh), options_(options),
      states_(mesh.tets.size() + 1), edge_point_(static_cast<std::size_t>(canonical_.edges), -1), workers_(options.threads) {
    require_valid_tau(options.tau);
    counts_.uncut = canonical_.tets();
}

void SubdivisionEngine::reset() {
    for (const int tet : parents_) {
        for (const int edge : canonical_.records[tet].edge) edge_point_[edge] = -1;
        states_[static_cast<std::size_t>(tet) + 1].cut = -1;
    }
    parents_.clear();
    plans_.clear();
    loose_.clear();
    points_.clear();
    child_tets_.clear();
    child_links_.clear();
    child_centroids_.clear();
    child_volumes_.clear();
    child_parents_.clear();
    counts_ = {.uncut = canonical_.tets()};
    cuts_ = 0;
    first_parent_ = 0;
    first_new_child_ = 0;
}

bool SubdivisionEngine::passes_disc(const Cut& cut, const CuttingPlane& plane, int tet) const {
    std::array<Eigen::Vector3d, 4> corners;
    std::array<double, 4> distances{};
    for (int i = 0; i < 4; ++i) {
        const Vector4& x = canonical_.vertices[canonical_.records[tet].sorted[i]];
        corners[i] = {x[0], x[1], x[2]};
        distances[i] = plane.raised(x);
    }
    return passes(cut, corners, distances);
}

/// Appends the tets of a box that the plane divides and that are whole, asked for, and near the disc.
inline void SubdivisionEngine::find_in_box(std::size_t box, const Cut& cut, const CuttingPlane& plane, const Among& among,
                                           Buffer<std::uint64_t>& found) const {
    boxes_.visit_box(box, plane, [&](int tet, unsigned mask) {
        if (is_cut(tet) || !among.has(tet) || (std::isfinite(cut.radius) && !passes_disc(cut, plane, tet))) return;
        found.push_back(16 * static_cast<std::uint64_t>(tet) + mask);
    });
}

void SubdivisionEngine::find_parents(const Cut& cut, const CuttingPlane& plane, const Among& among) {
    found_.clear();
    if (workers_.alone()) {
        boxes_.near_boxes(cut, [&](std::size_t box) { find_in_box(box, cut, plane, among, found_); });
    } else {
        find_near_together(cut, plane, among);
    }
    // Where the mesh is numbered along the curve, they are in order already.
    if (!std::is_sorted(found_.begin(), found_.end())) std::sort(found_.data(), found_.data() + found_.size());
}

void SubdivisionEngine::find_near_together(const Cut& cut, const CuttingPlane& plane, const Among& among) {
    constexpr std::size_t boxes_a_chunk = 256;
    std::vector<std::size_t> boxes;
    boxes_.near_boxes(cut, [&](std::size_t box) { boxes.push_back(box); });
    const std::size_t chunks = (boxes.size() + boxes_a_chunk - 1) / boxes_a_chunk;
    if (chunk_found_.size() < chunks) chunk_found_ = std::vector<Buffer<std::uint64_t>>(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        chunk_found_[chunk].clear();
        for (std::size_t i = chunk * boxes_a_chunk; i < std::min(boxes.size(), (chunk + 1) * boxes_a_chunk); ++i) {
            find_in_box(boxes[i], cut, plane, among, chunk_found_[chunk]);
        }
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const Buffer<std::uint64_t>& found = chunk_found_[chunk];
        std::copy(found.begin(), found.end(), found_.grow_by(found.size()));
    }
}

void SubdivisionEngine::write_all_parents(const CuttingPlane& plane) {
    const std::size_t count = parents_.size() - first_parent_, chunks = (count + chunk_size - 1) / chunk_size;
    if (workers_.alone() || count < together_from) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) write_parents(plane, chunk, loose_);
        return;
    }
    if (chunk_loose_.size() < chunks) chunk_loose_ = std::vector<Buffer<LooseFace>>(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        chunk_loose_[chunk].clear();
        write_parents(plane, chunk, chunk_loose_[chunk]);
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const Buffer<LooseFace>& part = chunk_loose_[chunk];
        std::copy(part.begin(), part.end(), loose_.grow_by(part.size()));
    }
}

void SubdivisionEngine::write_parents(const CuttingPlane& plane, std::size_t chunk, Buffer<LooseFace>& loose) {
    const std::size_t first = 1 + chunk * chunk_size, last = std::min(plans_.size(), first + chunk_size);
    const int children = plans_[first].first_half_face / 4 - canonical_.tets();
    const ChildArrays out{child_tets_.data() + children,    child_links_.data() + children,   child_centroids_.data() + children,
                          child_volumes_.data() + children, child_parents_.data() + children, points_.data() - canonical_.vertices.size()};
    write_children(plane, plans_.data() + first, plans_.data() + last, layouts_, canonical_.vertices.data(), out, loose);
}

Counts SubdivisionEngine::cut(const Cut& cut, const Among& among) {
    const Cut valid = checked(cut);
    const CuttingPlane plane{{valid.normal[0], valid.normal[1], valid.normal[2]},
                             {valid.centre[0], valid.centre[1], valid.centre[2]}, options_.tau};
    const Counts before = counts_;
    first_parent_ = parents_.size();
    first_new_child_ = static_cast<int>(child_tets_.size());
    find_parents(valid, plane, among);
    plan_parents();
    write_all_parents(plane);
    ++cuts_;
    return {counts_.uncut, counts_.three_one - before.three_one, counts_.two_two - before.two_two};
}

}  // namespace cleave::subdivision
