# Counts of the processes of a study, which end by _exit().
if(CLEAVE_COVERAGE)
  target_sources(cleave_validation PRIVATE ${CMAKE_CURRENT_LIST_DIR}/exit.c)
  target_link_options(cleave_validation INTERFACE -Wl,--wrap=_exit)
endif()

# The count itself: gcov belongs to g++.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_test(NAME coverage/known_program COMMAND ${CMAKE_CURRENT_LIST_DIR}/coverage_test.py ${CMAKE_CXX_COMPILER})
  set_tests_properties(coverage/known_program PROPERTIES LABELS fast TIMEOUT 120)
endif()
