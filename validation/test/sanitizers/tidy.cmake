# ninja tidy: clang-tidy (Debian package clang-tidy) by .clang-tidy over solver/ and validation/. Some minutes on many processors, an hour on two.
find_program(CLEAVE_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
if(CLEAVE_RUN_CLANG_TIDY)
  add_custom_target(tidy USES_TERMINAL
    COMMAND ${CLEAVE_RUN_CLANG_TIDY} -quiet -p ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR}/solver/.*cpp ${CMAKE_SOURCE_DIR}/validation/.*cpp
    COMMENT "clang-tidy over solver/ and validation/")
endif()
