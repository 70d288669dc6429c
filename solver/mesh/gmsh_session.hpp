#pragma once

#include "solver/mesh/tet_mesh.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace cleave::mesh {

/// A mesher failed on a shape: the message is the mesher's own, in one line.
class MeshingError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Gmsh, initialised for the life of this object; Gmsh is one per process, so a second session at the same time is a
/// std::logic_error. Silent, one thread, no user configuration; meshing repeats to the bit: Delaunay in 3D (Algorithm3D = 1;
/// HXT does not repeat, even with one thread), fixed random seed, sizes only from what the caller sets. Files are saved as
/// ASCII 4.1. Not thread-safe. Gmsh's own API (gmsh.h) is used directly in between, inside run().
class GmshSession {
public:
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;

    /// Calls `work`; what Gmsh throws (std::string in 4.8, std::exception later) becomes a MeshingError.
    template <class Work>
    decltype(auto) run(Work&& work) const {
        try {
            return std::forward<Work>(work)();
        } catch (const std::string& message) {
            throw MeshingError("gmsh: " + one_line(message));
        }
    }

    /// Drops all models and starts an empty one.
    void new_model(const std::string& name) const;
    /// MeshSizeMin = MeshSizeMax = size, m.
    void set_uniform_size(double size) const;
    /// Meshes the current model in 3D. Throws MeshingError.
    void generate() const;
    /// The current mesh: all tets (with their first physical volume's tag, else 0), the triangles of physical surfaces, the
    /// groups' names; vertices in the order of Gmsh's node tags, without those that no tet uses. Throws MeshingError without tets.
    TetMesh take_mesh() const;
    /// Gmsh's version, for fingerprints and provenance.
    static std::string version();

private:
    static std::string one_line(const std::string& message);
};

}  // namespace cleave::mesh
