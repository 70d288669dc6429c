#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace cleave::geometry {

/// The .msh of a recipe in `folder`: found there, or made: `build` leaves a model in the current Gmsh session,
/// which is meshed in 3D; `finish`, where given, then works on the mesh (opens a crack). The file's name carries a hash of `recipe`, which must name every parameter of the mesh.
/// Throws InputError at `recipe` where Gmsh cannot mesh it, EnvironmentError where the folder cannot be written.
std::filesystem::path cached_mesh(const std::filesystem::path& folder, const std::string& name, const std::string& recipe,
                                  const std::function<void()>& build, const std::function<void()>& finish = {});

}  // namespace cleave::geometry
