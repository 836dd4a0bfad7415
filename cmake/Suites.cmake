# asperity_discover_suites(PROGRAM LABEL): makes a GoogleTest program a test of CTest, run by
# tools/run_suite.py; of one that needs a display, each suite. The suites are listed when the program is
# linked (cmake/ListSuites.cmake).
set(suites_script ${CMAKE_CURRENT_LIST_DIR}/ListSuites.cmake)
set(suites_runner ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tools/run_suite.py)
set(labels_with_display app gui vtk)

function(asperity_discover_suites program label)
  set(runner ${suites_runner})
  set(apart OFF)
  if(label IN_LIST labels_with_display)
    list(APPEND runner --display)
    set(apart ON)
  endif()
  string(REGEX REPLACE "^asperity_|_tests$" "" prefix ${program})
  if(ASPERITY_GATE)
    string(PREPEND prefix ${ASPERITY_GATE}.)
  endif()
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${program}_suites.cmake)
  add_custom_command(
    TARGET ${program}
    POST_BUILD
    BYPRODUCTS ${suites}
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${program}> -D PREFIX=${prefix} -D LABEL=${label} -D
            APART=${apart} -D "RUNNER=${runner}" -D RESULTS=${CMAKE_BINARY_DIR}/results -D OUTPUT=${suites} -P
            ${suites_script}
    VERBATIM)
  set_property(TARGET ${program} APPEND PROPERTY LINK_DEPENDS ${suites_script})
  set(included ${CMAKE_CURRENT_BINARY_DIR}/${program}_included.cmake)
  file(WRITE ${included} "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n"
                         "  add_test(${prefix}_NOT_BUILT ${program}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${included})
endfunction()
