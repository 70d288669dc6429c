/// cleave-netgen SURFACE.obj SIZE INNER_SIZE OUT.msh: meshes the inside of a surface by NETGEN. A program of its own, because NETGEN aborts on
/// input it dislikes, never returns on some, and writes to stdout. mesh_by_netgen() calls it. Exit codes: netgen_protocol.hpp.

#include "solver/input/file_io.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/mesh/netgen_protocol.hpp"
#include "solver/mesh/obj_file.hpp"

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace nglib {  // the header's names are as general as Ng_Result's NG_OK: it wants a namespace
#include <nglib.h>
}

namespace {

using namespace cleave::mesh;
using nglib::Ng_Mesh;

nglib::Ng_Meshing_Parameters parameters(double size) {
    nglib::Ng_Meshing_Parameters wanted;
    wanted.uselocalh = 1;  // 0 crashes
    wanted.maxh = size;
    wanted.minh = netgen::smallest_part * size;  // curvature may refine as far as this
    wanted.elementsperedge = 1;
    wanted.elementspercurve = 1;
    wanted.grading = 0.3;
    return wanted;
}

void give_triangles(nglib::Ng_STL_Geometry* geometry, const SurfaceMesh& surface) {
    for (const SurfaceTriangle& triangle : surface.triangles) {
        Eigen::Vector3d corners[3];
        for (int i = 0; i < 3; ++i) corners[i] = surface.vertices[triangle.vertices[i]];
        nglib::Ng_STL_AddTriangle(geometry, corners[0].data(), corners[1].data(), corners[2].data());
    }
}

TetMesh taken(Ng_Mesh* from) {
    TetMesh mesh;
    for (int i = 1; i <= nglib::Ng_GetNP(from); ++i) {
        Eigen::Vector3d point;
        nglib::Ng_GetPoint(from, i, point.data());
        mesh.vertices.push_back(point);
    }
    for (int i = 1; i <= nglib::Ng_GetNE(from); ++i) {
        int corners[NG_VOLUME_ELEMENT_MAXPOINTS];
        nglib::Ng_GetVolumeElement(from, i, corners);
        // NETGEN's order is the other one: two corners change places.
        mesh.tets.push_back({corners[1] - 1, corners[0] - 1, corners[2] - 1, corners[3] - 1});
        mesh.regions.push_back(1);
    }
    return mesh;
}

using netgen::Stage;

Stage run(const SurfaceMesh& surface, double size, double inner_size, TetMesh& result) {
    nglib::Ng_Init();
    nglib::Ng_STL_Geometry* geometry = nglib::Ng_STL_NewGeometry();
    give_triangles(geometry, surface);
    if (nglib::Ng_STL_InitSTLGeometry(geometry) != nglib::NG_OK) return Stage::geometry;
    Ng_Mesh* mesh = nglib::Ng_NewMesh();
    nglib::Ng_Meshing_Parameters wanted = parameters(size);
    if (nglib::Ng_STL_MakeEdges(geometry, mesh, &wanted) != nglib::NG_OK) return Stage::edges;
    if (nglib::Ng_STL_GenerateSurfaceMesh(geometry, mesh, &wanted) != nglib::NG_OK) return Stage::surface;
    nglib::Ng_Meshing_Parameters inside = parameters(inner_size);
    if (nglib::Ng_GenerateVolumeMesh(mesh, &inside) != nglib::NG_OK) return Stage::volume;
    result = taken(mesh);
    return result.tets.empty() ? Stage::volume : Stage::done;
}

void limit_time() {
    const rlimit limit{netgen::most_seconds, netgen::most_seconds + 1};
    ::setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) return static_cast<int>(Stage::usage);
    limit_time();
    TetMesh mesh;
    const Stage stage = run(parse_obj(cleave::read_file(argv[1]), argv[1]), std::strtod(argv[2], nullptr), std::strtod(argv[3], nullptr), mesh);
    if (stage == Stage::done) write_msh(mesh, argv[4]);
    std::fflush(nullptr);
    std::_Exit(static_cast<int>(stage));  // without NETGEN's own destructors at exit, which have been seen to crash
}
