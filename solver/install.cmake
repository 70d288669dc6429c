# The package: find_package(cleave) gives cleave::solver, the whole method; cleave::NAME its parts, by folder.
include(CMakePackageConfigHelpers)

set(parts input parallel material mesh gmsh surface mesher recipes particles elasticity equilibrium contact fracture subdivision fragments rigid)
set(libraries ${parts})
list(TRANSFORM libraries PREPEND cleave_)
foreach(part IN LISTS parts)
  set_target_properties(cleave_${part} PROPERTIES EXPORT_NAME ${part})
endforeach()

add_library(cleave_solver INTERFACE)
target_link_libraries(cleave_solver INTERFACE ${libraries})
target_compile_features(cleave_solver INTERFACE cxx_std_20)
# Eigen's fixed-size types change their alignment with the instruction set: who links must be built for the same one.
target_compile_options(cleave_solver INTERFACE -march=x86-64-v3)
set_target_properties(cleave_solver PROPERTIES EXPORT_NAME solver)

set(config_folder lib/cmake/cleave)
install(TARGETS cleave_solver ${libraries} EXPORT cleaveTargets ARCHIVE DESTINATION lib/cleave COMPONENT development)
install(EXPORT cleaveTargets NAMESPACE cleave:: DESTINATION ${config_folder} COMPONENT development)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION include/cleave/solver COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN test EXCLUDE)
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/cleaveConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/cleaveConfig.cmake @ONLY)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/cleaveConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cleaveConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/cleaveConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT development)

# A program outside the tree links the package and strains a mesh. CXX_STANDARD and flags come from the package alone.
add_test(NAME package/outside_program
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/test/package_test.sh ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/package_test)
set_tests_properties(package/outside_program PROPERTIES LABELS fast TIMEOUT 600)
