# Equilibrium of the `conforming` particles, and the energy release rate.
find_package(TBB REQUIRED)
find_library(CLEAVE_CHOLMOD cholmod REQUIRED)
find_path(CLEAVE_SUITESPARSE_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)

cleave_library(cleave_equilibrium
  SOURCES conforming_box_tree.cpp conforming_walls.cpp conforming_faces.cpp conforming_traces.cpp conforming_body.cpp
          equilibrium_parallel.cpp equilibrium_operator.cpp equilibrium_rigid.cpp equilibrium_loads.cpp equilibrium_cg.cpp equilibrium_coarse.cpp
          equilibrium_assembly.cpp equilibrium_system.cpp equilibrium.cpp energy_release.cpp crack_tip_field.cpp stress_intensity.cpp
  LINK cleave_elasticity cleave_mesh cleave_parallel
  PRIVATE_LINK fmt::fmt ${CLEAVE_CHOLMOD})
target_include_directories(cleave_equilibrium SYSTEM PRIVATE ${CLEAVE_SUITESPARSE_INCLUDE})

cleave_test(equilibrium_test
  SOURCES test/conforming_test.cpp test/equilibrium_patch_test.cpp test/equilibrium_operator_test.cpp test/equilibrium_test.cpp
          test/energy_release_test.cpp test/stress_intensity_test.cpp
  LINK cleave_equilibrium TBB::tbb)
