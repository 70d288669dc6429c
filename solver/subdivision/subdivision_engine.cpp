#include "solver/subdivision/subdivision_engine.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::subdivision {

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

/// Appends the tets of these near boxes that the plane divides and that are whole, asked for, and near the disc.
void SubdivisionEngine::find_in_boxes(std::size_t first, std::size_t last, const Cut& cut, const CuttingPlane& plane, const Among& among,
                                      Buffer<std::uint64_t>& found) const {
    constexpr std::size_t ahead = 2;
    const CuttingPlane own_plane = plane;  // no store can change it
    const bool takes_all = cuts_ == 0 && among.has_all() && !std::isfinite(cut.radius);  // nothing to ask of a tet, nowhere to look it up
    for (std::size_t i = first; i < last; ++i) {
        if (i + ahead < last) boxes_.prefetch(near_[i + ahead]);
        std::uint64_t *begin = found.grow_by(TetBoxes::most), *end = begin;
        boxes_.visit_box(near_[i], own_plane, [&](int tet, unsigned number) {
            const bool is_wanted = takes_all || !(is_cut(tet) || !among.has(tet) || (std::isfinite(cut.radius) && !passes_disc(cut, own_plane, tet)));
            *end = 32 * static_cast<std::uint64_t>(tet) + number;
            end += is_wanted;
        });
        found.resize(found.size() - TetBoxes::most + static_cast<std::size_t>(end - begin));
    }
}

void SubdivisionEngine::find_parents(const Cut& cut, const CuttingPlane& plane, const Among& among) {
    near_.clear();
    boxes_.near_boxes(cut, [&](std::size_t box) { near_.push_back(static_cast<std::uint32_t>(box)); });
    found_.clear();
    if (workers_.alone()) {
        find_in_boxes(0, near_.size(), cut, plane, among, found_);
    } else {
        find_together(cut, plane, among);
    }
    // Where the mesh is numbered along the curve, they are in order already.
    if (!std::is_sorted(found_.begin(), found_.end())) std::sort(found_.data(), found_.data() + found_.size());
}

void SubdivisionEngine::find_together(const Cut& cut, const CuttingPlane& plane, const Among& among) {
    constexpr std::size_t boxes_a_chunk = 256;
    const std::size_t chunks = (near_.size() + boxes_a_chunk - 1) / boxes_a_chunk;
    if (chunk_found_.size() < chunks) chunk_found_ = std::vector<Buffer<std::uint64_t>>(chunks);
    workers_.for_chunks(chunks, [&](std::size_t chunk) {
        chunk_found_[chunk].clear();
        const std::size_t first = chunk * boxes_a_chunk, last = std::min(near_.size(), first + boxes_a_chunk);
        find_in_boxes(first, last, cut, plane, among, chunk_found_[chunk]);
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const Buffer<std::uint64_t>& found = chunk_found_[chunk];
        std::copy(found.begin(), found.end(), found_.grow_by(found.size()));
    }
}

Counts SubdivisionEngine::cut(const Cut& cut, const Among& among) {
    const Cut valid = checked(cut);
    const CuttingPlane plane{{valid.normal[0], valid.normal[1], valid.normal[2]},
                             {valid.centre[0], valid.centre[1], valid.centre[2]}, options_.tau};
    const Counts before = counts_;
    first_parent_ = parents_.size();
    first_new_child_ = static_cast<int>(child_tets_.size());
    find_parents(valid, plane, among);
    place_parents();
    divide_parents(plane);
    ++cuts_;
    return {counts_.uncut, counts_.three_one - before.three_one, counts_.two_two - before.two_two};
}

}  // namespace cleave::subdivision
