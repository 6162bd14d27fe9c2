# What every target of this project shares: strict warnings, reproducible arithmetic.

option(HIDWA_WERROR "Warnings are errors; for the compilers that this is tried with" OFF)

# Strict warnings, on our own targets only.
function(hidwa_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor $<$<BOOL:${HIDWA_WERROR}>:-Werror>)
endfunction()

# Same input, same bits: no contraction of a*b+c, which would depend on the instruction set.
function(hidwa_arithmetic target)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

option(HIDWA_UNITY "Compile several sources of a library at once: a build from nothing takes half the time, a changed file more" OFF)

# Most of the time goes into headers that many sources share.
function(hidwa_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${HIDWA_UNITY})
  # GCC 9 crashes where a function of HIDWA_VECTOR_CLONES is compiled together with what calls it.
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    file(STRINGS ${path} clones REGEX HIDWA_VECTOR_CLONES LIMIT_COUNT 1)
    if(clones)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()
