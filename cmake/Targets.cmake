# How Asperity's own targets are built: C++20, warnings are errors, includes from the top folder.

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

# GCC 12 sees std::string's operator+ write out of bounds (GCC bug 105329) where it optimizes less or
# compiles from precompiled headers; what is built without either keeps these warnings.
set(gcc_string_warnings -Wno-array-bounds -Wno-stringop-overflow)

# asperity_precompile(TARGET OWNER [HEADER ...]): with ASPERITY_PRECOMPILE, a target's sources start
# from the headers that its owner names; only the owner itself names them. It saves half the time of
# a build from nothing. A source must still include all that it uses: builds without it hold it to that.
function(asperity_precompile target owner)
  set(owners_tests asperity_test_support asperity_test_clicks)
  set(owners_all ${owners_tests} asperity_base asperity_ui_base asperity_session)
  if(NOT owner IN_LIST owners_${ASPERITY_PRECOMPILE})
    return()
  endif()
  # -fPIC: programs and libraries share precompiled headers only if they are compiled alike.
  target_compile_options(
    ${target} PRIVATE -fPIC "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>"
                      "$<$<CXX_COMPILER_ID:GNU>:${gcc_string_warnings}>")
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

# asperity_optimize_less(TARGET): -O1 for what runs once, as tests and the parsing of a command line:
# it saves a third to a half of the compiler's time. What they call keeps its own optimization.
function(asperity_optimize_less target)
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1>
                      "$<$<CXX_COMPILER_ID:GNU>:${gcc_string_warnings}>")
endfunction()

function(asperity_compile_options target)
  # -ffp-contract=off: a recorded run replays to the same bits whatever the optimizer fuses.
  # -Wno-missing-field-initializers: designated initializers leave defaults to the members.
  # -Wno-restrict: GCC 12 sees overlaps in std::string's own operator+ (GCC bug 105651).
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                      -Wno-missing-field-initializers -Werror
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off)
  target_include_directories(
    ${target} PUBLIC $<BUILD_INTERFACE:${asperity_top}>
                     $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/asperity>)
endfunction()

# asperity_library(NAME SOURCES ... [DEPENDS ...] [HEADERS OWNER [HEADER ...]]): one folder's static
# library; HEADERS: as asperity_precompile(), by default those of asperity_base.
function(asperity_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;HEADERS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS})
  asperity_compile_options(${name})
  if(NOT ARG_HEADERS)
    set(ARG_HEADERS asperity_base)
  endif()
  asperity_precompile(${name} ${ARG_HEADERS})
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
  if(asperity_window_test_main IN_LIST ARG_DEPENDS)
    asperity_precompile(${name} asperity_test_clicks)
  else()
    asperity_precompile(${name} asperity_test_support)
  endif()
  asperity_discover_suites(${name} ${ARG_LABEL})
endfunction()
