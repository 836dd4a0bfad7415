# Compiles a target's sources in batches: files that include up to ASPERITY_BATCH sources each, or as many as
# the target's property of that name says. Most of a source's compile time is the same headers over and over.
# A batch includes relative to the top folder, so that it is the same text in every checkout and the compiler
# cache finds it. docs/adr/0009-batches.md

# asperity_batches(TARGET): at the end of the folder's CMakeLists.txt, which may give sources options of their
# own until then. That a source is not compiled by itself holds for its whole folder: a target with one source
# has a batch, too, so that two such targets may share it.
function(asperity_batches target)
  if(ASPERITY_BATCH GREATER 1)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL asperity_batch_sources ${target})")
  endif()
endfunction()

# Sources with compile options of their own share batches with those of the same options. Sources with
# definitions of their own and what the build writes (it changes at each commit) stay apart, but not what
# Qt's moc writes. COMPILE_FLAGS,
# INCLUDE_DIRECTORIES and OBJECT_DEPENDS would not reach a batch: they are refused.
function(asperity_batch_sources target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  set(kinds)
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "[.](cpp|cxx)$")
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE OUTPUT_VARIABLE file)
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${file} is_made)
    get_source_file_property(definitions ${file} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
    if(is_made OR definitions)
      continue()
    endif()
    foreach(property COMPILE_FLAGS INCLUDE_DIRECTORIES OBJECT_DEPENDS)
      get_source_file_property(value ${file} TARGET_DIRECTORY ${target} ${property})
      if(value)
        message(FATAL_ERROR "${file}: ${property} does not reach the batch that it is compiled in. "
                            "Set COMPILE_OPTIONS, or COMPILE_DEFINITIONS, which keep it apart.")
      endif()
    endforeach()
    get_source_file_property(options ${file} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    string(MD5 kind "${options}")
    list(APPEND kinds ${kind})
    set(options_${kind} "${options}")
    list(APPEND sources_${kind} ${file})
  endforeach()
  list(REMOVE_DUPLICATES kinds)

  get_target_property(has_moc ${target} AUTOMOC)
  set(written 0)
  foreach(kind IN LISTS kinds)
    set(batched ${sources_${kind}})
    if(has_moc AND NOT options_${kind})
      list(APPEND batched ${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp)
    endif()
    asperity_write_batches(${target} "${options_${kind}}" ${written} written ${batched})
  endforeach()
endfunction()

# asperity_write_batches(TARGET OPTIONS BEFORE AFTER SOURCE ...): of sources with the same compile options;
# BEFORE: how many batches the target has already; AFTER: the variable that receives how many it has then.
function(asperity_write_batches target options before after)
  set(${after} ${before} PARENT_SCOPE)
  set(batched ${ARGN})
  list(LENGTH batched count)
  if(count EQUAL 0)
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
    set(text "// Sources of ${target} that are compiled together (cmake/Batches.cmake).\n")
    foreach(member IN LISTS members)
      set(base ${asperity_top})
      cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${member} is_made)
      if(is_made)
        set(base ${CMAKE_BINARY_DIR}/batches)
      endif()
      cmake_path(RELATIVE_PATH member BASE_DIRECTORY ${base} OUTPUT_VARIABLE included)
      string(APPEND text "#include \"${included}\"\n")
    endforeach()
    math(EXPR number "${before} + ${batch}")
    set(file ${CMAKE_BINARY_DIR}/batches/${target}_${number}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
    target_sources(${target} PRIVATE ${file})
    # What moc writes is made anew in the same build: the batch waits for it.
    set(made ${members})
    list(FILTER made INCLUDE REGEX "/mocs_compilation[.]cpp$")
    set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES OBJECT_DEPENDS "${made}")
    if(options)
      set_source_files_properties(${file} TARGET_DIRECTORY ${target} PROPERTIES COMPILE_OPTIONS "${options}")
    endif()
  endforeach()
  set(${after} ${number} PARENT_SCOPE)
  # Still of the target, for AUTOMOC to read, but not compiled by themselves.
  set_source_files_properties(${batched} TARGET_DIRECTORY ${target} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()
