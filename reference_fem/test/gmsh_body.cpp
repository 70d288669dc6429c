#include "reference_fem/test/gmsh_body.hpp"

#include "reference_fem/test/msh_text.hpp"

#include <gmsh.h>

namespace cleave::fem::testing {

std::string quarter_plate_with_hole(const std::string& name) {
    const std::string path = write_temporary(name, "");
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    const int plate = gmsh::model::occ::addBox(0, 0, 0, 4, 4, 0.3);
    const int hole = gmsh::model::occ::addCylinder(0, 0, -1, 0, 0, 2, 1);
    gmsh::vectorpair body;
    std::vector<gmsh::vectorpair> map;
    gmsh::model::occ::cut({{3, plate}}, {{3, hole}}, body, map);
    gmsh::model::occ::synchronize();
    gmsh::model::addPhysicalGroup(3, {body.front().second}, 1);
    for (const char* option : {"Mesh.MeshSizeFromPoints", "Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromCurvature"})
        gmsh::option::setNumber(option, 0);
    const int size = gmsh::model::mesh::field::add("MathEval");
    gmsh::model::mesh::field::setString(size, "F", "0.1 + 0.4 * (Sqrt(x * x + y * y) - 1)");
    gmsh::model::mesh::field::setAsBackgroundMesh(size);
    gmsh::model::mesh::generate(3);
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::write(path);
    gmsh::finalize();
    return path;
}

}  // namespace cleave::fem::testing
