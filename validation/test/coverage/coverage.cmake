# Counts of the processes of a study, which end by _exit().
if(CLEAVE_COVERAGE)
  target_sources(cleave_validation PRIVATE ${CMAKE_CURRENT_LIST_DIR}/exit.c)
  target_link_options(cleave_validation INTERFACE -Wl,--wrap=_exit)
endif()
