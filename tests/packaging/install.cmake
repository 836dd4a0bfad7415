# Installs the program as a user does, and runs it from there; nothing else of the tree is found.
#   cmake -DBUILD=build/release -P tests/packaging/install.cmake
set(prefix ${BUILD}/installed_program)
file(REMOVE_RECURSE ${prefix})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component asperity --prefix ${prefix}
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)

foreach(
  file
  bin/asperity
  lib/udev/rules.d/70-asperity-hid.rules
  libexec/asperity/asperity_hdf5_reader
  share/applications/asperity.desktop
  share/asperity/data/scenes/granular_film.toml
  share/asperity/data/studies/positioning.toml
  share/asperity/docs
  share/bash-completion/completions/asperity
  share/doc/asperity/copyright
  share/icons/hicolor/scalable/apps/asperity.svg
  share/man/man1/asperity.1.gz
  share/mime/packages/asperity.xml)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
file(GLOB_RECURSE archives ${prefix}/*.a ${prefix}/*.h ${prefix}/*.cmake)
if(archives)
  message(FATAL_ERROR "what programs link is installed with the program: ${archives}")
endif()

set(program ${CMAKE_COMMAND} -E env --unset=ASPERITY_DATA ${prefix}/bin/asperity)
execute_process(COMMAND ${program} info ${prefix}/share/asperity/data/samples/steps.gsf
                WORKING_DIRECTORY / COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
if(NOT output MATCHES "Gwyddion Simple Field")
  message(FATAL_ERROR "the installed program reads no sample: ${output}")
endif()
# Without a scene it takes the one that comes with it.
execute_process(COMMAND ${program} loop --duration 1 WORKING_DIRECTORY /
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
if(NOT output MATCHES "ticks")
  message(FATAL_ERROR "the installed program finds no scene of its own: ${output}")
endif()

# A compact recording is read by a program that is installed beside it.
set(run ${prefix}/run)
execute_process(COMMAND ${program} explore ${prefix}/share/asperity/data/scenes/polystyrene.toml --duration 0.1
                        --format h5 --out ${run}
                WORKING_DIRECTORY / COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
execute_process(COMMAND ${program} replay ${run} --out ${prefix}/again WORKING_DIRECTORY /
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
if(NOT output MATCHES "bit-identical")
  message(FATAL_ERROR "the installed program reads no compact recording: ${output}")
endif()

# What it completes are its own subcommands.
execute_process(
  COMMAND
    ${CMAKE_COMMAND} -E env PATH=${prefix}/bin:$ENV{PATH} bash -c
    "source ${prefix}/share/bash-completion/completions/asperity; COMP_WORDS=(asperity con); COMP_CWORD=1; _asperity; printf '%s\\n' \"\${COMPREPLY[@]}\"; COMP_WORDS=(asperity convert --lev); COMP_CWORD=2; _asperity; printf '%s\\n' \"\${COMPREPLY[@]}\""
  WORKING_DIRECTORY / COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
foreach(word convert contact --level --level-points)
  if(NOT output MATCHES "(^|\n)${word}\n")
    message(FATAL_ERROR "${word} is not completed: ${output}")
  endif()
endforeach()
