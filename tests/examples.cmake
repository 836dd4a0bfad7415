# Installs the libraries, builds the examples against them alone, and runs each.
#   cmake -DBUILD=build/release -DSOURCE=. -P tests/examples.cmake
set(prefix ${BUILD}/installed)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${prefix})
run(${CMAKE_COMMAND} --install ${BUILD} --component libraries --prefix ${prefix})
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/examples -B ${prefix}/examples
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run(${CMAKE_COMMAND} --build ${prefix}/examples)

run(${prefix}/examples/contact_curve)
if(NOT output MATCHES "retract,")
  message(FATAL_ERROR "contact_curve printed no curve")
endif()
run(${prefix}/examples/closest_points ${SOURCE}/data/samples/self_affine.gsf)
if(NOT output MATCHES ",nearest\n")
  message(FATAL_ERROR "closest_points proved none")
endif()
run(${prefix}/examples/scripted_path ${SOURCE}/examples/sphere.toml)
if(NOT output MATCHES "time_s,.*snap_in_ahead")
  message(FATAL_ERROR "scripted_path came to no sample")
endif()
