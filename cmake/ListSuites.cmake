# Writes OUTPUT, a file that CTest includes: a test PREFIX.SUITE with LABEL for each suite of the
# GoogleTest program PROGRAM, run by the command RUNNER, with its results in the folder RESULTS.
# Suites named ...Long have the label "long" instead and run by `ctest --preset long` only; suites
# named ...Alone run while no other test does: they read the clock.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listing TIMEOUT 60
                COMMAND_ERROR_IS_FATAL ANY)
# A suite stands at the beginning of its line, with a dot; its tests are indented.
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.[ \n]" suites "${listing}")
set(tests "")
foreach(suite ${suites})
  string(REGEX REPLACE "[^A-Za-z0-9_/]" "" suite ${suite})
  string(REPLACE / - file ${PREFIX}.${suite})
  set(command ${RUNNER} --results ${RESULTS}/${file} ${PROGRAM} ${suite}.*)
  string(REPLACE ";" "]=] [=[" command "${command}")
  # The runner limits the time of each test: CTest must not end the suite before.
  set(properties LABELS ${LABEL} TIMEOUT 86400)
  # Suites of windows are the longest. A fresh machine knows no times: they begin first there, so
  # that no core waits for the last one.
  if(LABEL STREQUAL gui)
    list(APPEND properties COST 100)
  endif()
  if(suite MATCHES "Long$")
    list(TRANSFORM properties REPLACE "^${LABEL}$" long)
  elseif(suite MATCHES "Alone$")
    list(APPEND properties RUN_SERIAL TRUE)
  endif()
  list(JOIN properties " " properties)
  string(APPEND tests "add_test(${PREFIX}.${suite} [=[${command}]=])\n"
                      "set_tests_properties(${PREFIX}.${suite} PROPERTIES ${properties})\n")
endforeach()
file(WRITE ${OUTPUT} "${tests}")
