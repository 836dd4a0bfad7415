# How Asperity's own targets are built: C++20, many warnings, includes from the top folder.

include(GNUInstallDirs)
# By this file's own place: the plugin for ParaView is a project of its own over the same core.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH asperity_top)
set(core_folder ${asperity_top}/core)  # what others may link: cmake/Install.cmake

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${asperity_top}/tools/cached_compiler.sh)
endif()

if(ASPERITY_SANITIZE)
  # Left out of UBSan: what AddressSanitizer stops at, too (null), and what costs a fifth of the
  # compiler's time and found nothing yet (object-size, vptr).
  add_compile_options(-fsanitize=${ASPERITY_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all -fno-sanitize=null,object-size,vptr
                      -fsanitize-ignorelist=${asperity_top}/tools/sanitizer_ignorelist.txt)
  add_link_options(-fsanitize=${ASPERITY_SANITIZE})
endif()

# asperity_optimize_less(TARGET): -O1 for what runs once or waits for a user, as tests, the parsing of a
# command line, dialogs: it saves a fifth to a half of the compiler's time. What they call keeps its own
# optimization.
function(asperity_optimize_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Compiles a target's sources in batches: files that include up to ASPERITY_BATCH sources each, or as many as
# the target's property of that name says. Most of a source's compile time is the same headers over and over. A batch includes from the top folder, so that
# it is the same text in every checkout and the compiler cache finds it. Apart stay sources with options
# of their own and what the build writes (it changes at each commit).
function(asperity_batch_sources target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  set(batched)
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "[.](cpp|cxx)$")
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE OUTPUT_VARIABLE file)
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${file} is_made)
    set(apart ${is_made})
    foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS)
      get_source_file_property(own ${file} TARGET_DIRECTORY ${target} ${property})
      if(own)
        set(apart TRUE)
      endif()
    endforeach()
    if(NOT apart)
      list(APPEND batched ${file})
    endif()
  endforeach()

  list(LENGTH batched count)
  if(count LESS 2)
    return()
  endif()
  get_target_property(size ${target} ASPERITY_BATCH)
  if(NOT size)
    set(size ${ASPERITY_BATCH})
  endif()
  # Of one size, so that no batch is much shorter than the others.
  math(EXPR batches "(${count} + ${size} - 1) / ${size}")
  foreach(batch RANGE 1 ${batches})
    math(EXPR first "${count} * (${batch} - 1) / ${batches}")
    math(EXPR number "${count} * ${batch} / ${batches} - ${first}")
    list(SUBLIST batched ${first} ${number} members)
    set(text "// Sources of ${target} that are compiled together (cmake/Targets.cmake).\n")
    foreach(member IN LISTS members)
      cmake_path(RELATIVE_PATH member BASE_DIRECTORY ${asperity_top} OUTPUT_VARIABLE included)
      string(APPEND text "#include \"${included}\"\n")
    endforeach()
    set(file ${CMAKE_BINARY_DIR}/batches/${target}_${batch}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
    target_sources(${target} PRIVATE ${file})
  endforeach()
  # Still of the target, for AUTOMOC to read, but not compiled by themselves.
  set_source_files_properties(${batched} TARGET_DIRECTORY ${target} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()

# asperity_batches(TARGET): as asperity_batch_sources() at the end of the folder's CMakeLists.txt, which may
# give sources options of their own until then.
function(asperity_batches target)
  if(ASPERITY_BATCH GREATER 1)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL asperity_batch_sources ${target})")
  endif()
endfunction()

function(asperity_compile_options target)
  # -ffp-contract=off: a recorded run replays to the same bits whatever the optimizer fuses.
  # -Wno-missing-field-initializers: designated initializers leave defaults to the members.
  # GCC 12 sees std::string's own operator+ overlap (-Wrestrict, GCC bug 105651) and write out of bounds
  # (-Warray-bounds, -Wstringop-overflow, GCC bug 105329).
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                      -Wno-missing-field-initializers
                      "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>"
                      -ffp-contract=off)
  if(ASPERITY_BATCH GREATER 1)
    # In a batch a name of another source is shadowed, and GCC takes the sources for headers, whose types must
    # not use an anonymous namespace. Of a source by itself, dev and tools/compile_alone.py warn of both.
    target_compile_options(${target} PRIVATE -Wno-shadow
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  target_include_directories(
    ${target} PUBLIC $<BUILD_INTERFACE:${asperity_top}>
                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/asperity>)
endfunction()

# asperity_library(NAME SOURCES ... [DEPENDS ...]): one folder's static library.
function(asperity_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS})
  asperity_compile_options(${name})
  asperity_batches(${name})
  cmake_path(IS_PREFIX core_folder ${CMAKE_CURRENT_SOURCE_DIR} is_core)
  if(is_core)
    string(REPLACE asperity_ "" exported ${name})
    set_target_properties(${name} PROPERTIES EXPORT_NAME ${exported})
    set_property(GLOBAL APPEND PROPERTY asperity_installed_libraries ${name})
  endif()
endfunction()

# asperity_test_runs(NAME PROGRAM): a test program that starts another.
function(asperity_test_runs name program)
  if(TARGET ${name})
    add_dependencies(${name} ${program})
  endif()
endfunction()

# asperity_test(NAME LABEL core|io|vtk|... SOURCES ... DEPENDS ... [GATES asan|tsan ...]): one
# GoogleTest program; each of its suites is a test of CTest (cmake/Suites.cmake). GATES: where it is
# built and run, too (ASPERITY_GATE; docs/testing.md).
function(asperity_test name)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;DEPENDS;GATES" ${ARGN})
  if(ASPERITY_GATE)
    if(NOT ASPERITY_GATE IN_LIST ARG_GATES)
      return()
    endif()
    add_dependencies(asperity_gate ${name})
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} asperity_test_support asperity_sanitizer
                                        GTest::gtest_main)
  asperity_compile_options(${name})
  asperity_optimize_less(${name})
  asperity_batches(${name})
  asperity_discover_suites(${name} ${ARG_LABEL})
endfunction()
