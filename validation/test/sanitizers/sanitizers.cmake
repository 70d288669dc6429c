# What the labels `sanitizers` and `coverage` run (./cleave test --label L): the fast Google Test programs of solver/ and validation/, named
# in checked_tests.txt, one a line. Left out: benchmarks and reports (no code of the method), and tests written as scripts.
add_executable(sanitizer_twin EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/twin.cpp)
target_include_directories(sanitizer_twin PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(sanitizer_twin PRIVATE cleave_parallel)
cleave_warnings(sanitizer_twin)
set_target_properties(sanitizer_twin PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

get_property(checked_tests GLOBAL PROPERTY CLEAVE_CHECKED_TESTS)
set(checked_programs)
foreach(name IN LISTS checked_tests)
  string(APPEND checked_programs "$<TARGET_FILE:${name}>\n")
endforeach()
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/checked_tests.txt CONTENT "${checked_programs}")
add_custom_target(checked_tests DEPENDS ${checked_tests} sanitizer_twin)
