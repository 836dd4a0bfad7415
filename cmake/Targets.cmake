# How Asperity's own targets are built: C++20, many warnings, includes from the top folder.

include(GNUInstallDirs)
# By this file's own place: the plugin for ParaView is a project of its own over the same core.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH asperity_top)
include(${CMAKE_CURRENT_LIST_DIR}/Batches.cmake)
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

function(asperity_compile_options target)
  # -ffp-contract=off: a recorded run replays to the same bits whatever the optimizer fuses.
  # -Wno-missing-field-initializers: designated initializers leave defaults to the members.
  # GCC 12, where it optimizes, sees std::string's own functions overlap (-Wrestrict, GCC bugs 105329 and
  # 105651) and write out of bounds (-Warray-bounds, -Wstringop-overflow).
  set(is_optimizing_gcc $<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>)
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                      -Wno-missing-field-initializers
                      "$<${is_optimizing_gcc}:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>"
                      -ffp-contract=off)
  if(ASPERITY_BATCH GREATER 1)
    # In a batch a name of another source is shadowed, and GCC takes the sources for headers, whose types must
    # not use an anonymous namespace. Of a source by itself, dev and tools/compile_alone.py warn of both.
    target_compile_options(${target} PRIVATE -Wno-shadow
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  # GCC's garbage collection takes a tenth of its time: it begins at 400 MB.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=400000>")
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
  if(ASPERITY_SANITIZE STREQUAL thread)
    # clang 14 does not watch the members of an object on the stack in the function that it belongs to, nor
    # in what is inlined there: a race between a test and the loop that it owns would stay unseen.
    target_compile_options(${name} PRIVATE -fno-inline)
  endif()
  asperity_optimize_less(${name})
  asperity_batches(${name})
  asperity_discover_suites(${name} ${ARG_LABEL})
endfunction()
