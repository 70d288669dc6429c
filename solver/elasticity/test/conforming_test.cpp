// Faces, visibility, traces and the gradient operator they make.
#include "solver/elasticity/conforming_walls.hpp"
#include "solver/elasticity/test/equilibrium_bodies.hpp"

#include <gtest/gtest.h>

namespace cleave::elasticity::test {
namespace {

std::map<int, material::Stiffness> one_material() { return {{0, triclinic()}}; }

TEST(BoxTree, finds_what_brute_force_finds) {
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto random = [&] { return Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator)); };
    std::vector<Box> boxes;
    for (int n = 0; n < 500; ++n) {
        const Eigen::Vector3d low = random();
        boxes.emplace_back(low, low + 0.1 * random());
    }
    const BoxTree tree(boxes);
    for (int n = 0; n < 100; ++n) {
        const Eigen::Vector3d low = random();
        const Box query(low, low + 0.3 * random());
        std::vector<int> expected;
        for (int i = 0; i < 500; ++i)
            if (boxes[i].intersects(query)) expected.push_back(i);
        EXPECT_EQ(tree.touching(query), expected);
    }
}

TEST(Faces, areas_close_every_tet_and_interior_faces_are_shared) {
    const mesh::TetMesh mesh = tagged_cube(3);
    const FaceSet faces = collect_faces(mesh);
    std::vector<Eigen::Vector3d> closed(mesh.tets.size(), Eigen::Vector3d::Zero());
    double boundary = 0;
    for (const Face& face : faces.faces) {
        closed[face.inside] += face.area;
        if (face.is_boundary()) boundary += face.area.norm();
        else closed[face.outside] -= face.area;
    }
    for (const Eigen::Vector3d& sum : closed) EXPECT_LT(sum.norm(), 1e-15);
    EXPECT_NEAR(boundary, 6, 1e-12);
    const std::vector<int> ids = surface_ids(mesh, faces);
    for (int f = 0; f < faces.size(); ++f) EXPECT_EQ(ids[f], faces.faces[f].is_boundary() ? side_of(faces.faces[f].centroid) : -1);
}

TEST(Faces, pieces_of_a_body_cut_through) {
    mesh::TetMesh mesh = particles::test::box_mesh(2, 0);
    open_crack(mesh, [](const Eigen::Vector3d& x) { return std::abs(x.z() - 0.5) < 1e-9; });
    const std::vector<int> piece = connected_pieces(collect_faces(mesh), static_cast<int>(mesh.tets.size()));
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        EXPECT_EQ(piece[tet], mesh::tet_centroid(mesh, static_cast<int>(tet)).z() > 0.5);
}

TEST(Walls, block_segments_that_cross_them_and_those_through_an_edge) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    const FaceSet faces = collect_faces(mesh);
    std::vector<char> opaque;
    for (const Face& face : faces.faces) opaque.push_back(face.is_boundary());
    const Walls walls(mesh, faces, opaque);
    const std::vector<int> all = walls.near(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
    const Eigen::Vector3d below(0.5, 0.47, 0.4), above(0.52, 0.5, 0.6), beside(0.9, 0.9, 0.4), beside_above(0.93, 0.88, 0.6);
    EXPECT_FALSE(walls.visible(below, above, all));
    EXPECT_TRUE(walls.visible(beside, beside_above, all));
    EXPECT_TRUE(walls.visible(below, beside, all));
    // Straight through a vertex of the crack, where six triangles meet.
    EXPECT_FALSE(walls.visible({0.5, 0.5, 0.4}, {0.5, 0.5, 0.6}, all));
    // The eye on a wall is not blocked by that wall.
    EXPECT_TRUE(walls.visible({0.51, 0.47, 0.5}, below, all));
}

TEST(Traces, no_stencil_reaches_across_a_crack) {
    const mesh::TetMesh mesh = cracked_cube(6, 0.4);
    const ConformingBody body = make_conforming_body(mesh, one_material());
    int lips = 0, blind = 0;
    for (const Fit& fit : body.stencils.fits) {
        const Eigen::Vector3d& x = body.faces.faces[fit.face].centroid;
        if (!body.faces.faces[fit.face].is_boundary() || side_of(x) != crack) continue;
        ++lips;
        const double side = body.particles.position[body.faces.faces[fit.face].inside].z() - 0.5;
        for (const int k : fit.seen) blind += (body.particles.position[k].z() - 0.5) * side < 0;
    }
    EXPECT_GT(lips, 20);
    EXPECT_EQ(blind, 0);
    // Must-fail twin: the same body without its crack has stencils across the plane.
    mesh::TetMesh whole = particles::test::box_mesh(6, 0.15);
    int across = 0;
    const ConformingBody sound = make_conforming_body(whole, one_material());
    for (const Fit& fit : sound.stencils.fits)
        if (std::abs(sound.faces.faces[fit.face].centroid.z() - 0.5) < 0.02)
            for (const int k : fit.seen) across += sound.particles.position[k].z() > 0.5;
    EXPECT_GT(across, 20);
}

/// Largest sum |phi| of any face.
double most_weight(const ConformingBody& body) {
    double most = 0;
    for (int f = 0; f < body.faces.size(); ++f) {
        double sum = 0;
        for (std::size_t n = body.traces.offset[f]; n < body.traces.offset[f + 1]; ++n) sum += std::abs(body.traces.weight[n]);
        most = std::max(most, sum);
    }
    return most;
}

TEST(Traces, growth_bounds_the_weights_that_poor_stencils_at_a_crack_would_have) {
    const mesh::TetMesh mesh = cracked_cube(6, 0.3);
    const ConformingBody body = make_conforming_body(mesh, one_material());
    ASSERT_EQ(body.stencils.report.best_tried, 0);
    EXPECT_LE(most_weight(body), 3 + 1e-12);
    EXPECT_GT(most_weight(make_conforming_body(mesh, one_material(), {.least_moment = 0, .most_weight = 1e300})), 10);
}

/// Largest error of a linear field's gradient, relative.
double linear_error(const ConformingBody& body) {
    const LinearField field;
    std::vector<Eigen::Vector3d> u, trace;
    for (const Eigen::Vector3d& x : body.particles.position) u.push_back(field(x));
    face_displacements(body, u, trace);
    double worst = 0;
    for (int i = 0; i < body.particles.size(); ++i) worst = std::max(worst, (face_gradient(body, i, trace) - field.gradient).norm());
    return worst / field.gradient.norm();
}

TEST(ConformingOperator, linear_fields_are_exact) {
    EXPECT_LT(linear_error(make_conforming_body(tagged_cube(5), one_material())), 1e-12);
    EXPECT_LT(linear_error(make_conforming_body(cracked_cube(4, 0.3), one_material())), 1e-12);
}

TEST(ConformingOperator, linear_fields_are_exact_with_kernels_of_aspect_four_and_on_graded_meshes) {
    const mesh::TetMesh mesh = particles::test::box_mesh(5, 0.15, particles::test::graded(6));
    particles::Particles particles = particles::from_mesh(mesh);
    std::mt19937 generator(2);
    particles::test::stretch_kernels(particles, 4, generator);
    const ConformingBody body = make_conforming_body(mesh, particles, one_material());
    EXPECT_LT(linear_error(body), 1e-12);
    EXPECT_EQ(body.stencils.report.best_tried, 0);
    EXPECT_GT(body.stencils.report.grown, 0);
}

TEST(ConformingOperator, shepard_traces_are_not_exact) {
    EXPECT_GT(linear_error(make_conforming_body(tagged_cube(5), one_material(), {.order = 0})), 1e-2);
}

TEST(ConformingOperator, as_a_strain_operator_gives_the_same_gradients) {
    const ConformingBody body = make_conforming_body(tagged_cube(3), one_material());
    const StrainOperator op = conforming_operator(body);
    const std::vector<Eigen::Vector3d> u = random_vectors(body.particles.size(), 7);
    std::vector<Eigen::Vector3d> trace;
    face_displacements(body, u, trace);
    double worst = 0, scale = 0;
    for (int i = 0; i < body.particles.size(); ++i) {
        const Eigen::Matrix3d gradient = face_gradient(body, i, trace);
        worst = std::max(worst, (displacement_gradient(op, i, u) - gradient).norm());
        scale = std::max(scale, gradient.norm());
    }
    EXPECT_LT(worst, 1e-12 * scale);
    EXPECT_EQ(op.name, "conforming");
}

TEST(ConformingOperator, smoothed_gradients_keep_linear_gradients) {
    const ConformingBody body = make_conforming_body(tagged_cube(5), one_material());
    std::vector<Eigen::Matrix3d> exact;
    const auto gradient = [](const Eigen::Vector3d& x) -> Eigen::Matrix3d {
        return LinearField{}.gradient * (1 + x.x() - 2 * x.y() + 3 * x.z());
    };
    for (const Eigen::Vector3d& x : body.particles.position) exact.push_back(gradient(x));
    const std::vector<Eigen::Matrix3d> smoothed = smoothed_gradients(body, exact);
    for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_LT((smoothed[i] - exact[i]).norm(), 1e-12 * exact[i].norm() + 1e-14);
}

TEST(ConformingBody, a_single_tet_takes_the_best_tried) {
    mesh::TetMesh mesh{};
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.tets = {{0, 1, 2, 3}};
    mesh.regions = {0};
    const ConformingBody body = make_conforming_body(mesh, one_material());
    EXPECT_EQ(body.stencils.report.best_tried, 4);
    for (const double weight : body.traces.weight) EXPECT_NEAR(weight, 1, 1e-12);
}

TEST(ConformingBody, moving_nothing_changes_no_bit_and_turned_tets_are_refused) {
    const mesh::TetMesh mesh = cracked_cube(4, 0.3);
    const ConformingBody body = make_conforming_body(mesh, one_material());
    EXPECT_EQ(move_body(body, mesh).traces.weight, body.traces.weight);
    mesh::TetMesh turned = mesh;
    std::swap(turned.vertices[mesh.tets[0][0]], turned.vertices[mesh.tets[0][1]]);
    EXPECT_THROW(move_body(body, turned), std::invalid_argument);
}

TEST(ConformingBody, names_the_region_without_a_stiffness) {
    mesh::TetMesh mesh = tagged_cube(2);
    mesh.regions[3] = 9;
    try {
        make_conforming_body(mesh, one_material());
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("region 9"), std::string::npos);
    }
}

}  // namespace
}  // namespace cleave::elasticity::test
