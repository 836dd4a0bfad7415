# Writes OUTPUT, a file that CTest includes: tests that run the GoogleTest program PROGRAM by the command
# RUNNER, with their results in the folder RESULTS. With APART each suite is a test PREFIX.SUITE with
# LABEL, otherwise all of them are one test PREFIX: to start a process takes longer than most suites.
# Suites named ...Long have the label "long" instead and run by `ctest --preset long` only; suites
# named ...Alone run while no other test does: they read the clock. Both are tests of their own.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listing TIMEOUT 60
                COMMAND_ERROR_IS_FATAL ANY)
set(tests "")

# add(NAME FILTER [PROPERTY VALUE] ...)
function(add name filter)
  string(REPLACE / - file ${name})
  set(command ${RUNNER} --results ${RESULTS}/${file} ${PROGRAM} ${filter})
  string(REPLACE ";" "]=] [=[" command "${command}")
  # The runner limits the time of each test: CTest must not end the suite before.
  list(JOIN ARGN " " properties)
  string(APPEND tests "add_test(${name} [=[${command}]=])\n"
                      "set_tests_properties(${name} PROPERTIES TIMEOUT 86400 ${properties})\n")
  set(tests "${tests}" PARENT_SCOPE)
endfunction()

# A suite stands at the beginning of its line, with a dot; its tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.[ \n]" suites "${listing}")
string(REGEX MATCHALL "\n  [^\n]" functions "${listing}")
set(together "")
set(apart "")
foreach(suite ${suites})
  string(REGEX REPLACE "[^A-Za-z0-9_/]" "" suite ${suite})
  if(suite MATCHES "Long$")
    add(${PREFIX}.${suite} ${suite}.* LABELS long)
    list(APPEND apart ${suite}.*)
  elseif(suite MATCHES "Alone$")
    add(${PREFIX}.${suite} ${suite}.* LABELS ${LABEL} RUN_SERIAL TRUE)
    list(APPEND apart ${suite}.*)
  else()
    list(APPEND together ${suite})
  endif()
endforeach()
# A fresh machine knows no times. What is longest begins first there, so that no core waits for the
# last one: suites of windows, then programs of many tests.
if(APART)
  foreach(suite ${together})
    if(LABEL STREQUAL gui)
      add(${PREFIX}.${suite} ${suite}.* LABELS ${LABEL} COST 1000)
    else()
      add(${PREFIX}.${suite} ${suite}.* LABELS ${LABEL})
    endif()
  endforeach()
elseif(together)
  list(LENGTH functions cost)
  set(wanted *)
  if(apart)
    list(JOIN apart ":" apart)
    set(wanted *-${apart})
  endif()
  add(${PREFIX} ${wanted} LABELS ${LABEL} COST ${cost})
endif()
file(WRITE ${OUTPUT} "${tests}")
