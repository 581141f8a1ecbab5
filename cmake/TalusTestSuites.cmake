# Read by ctest when it starts: lists the tests of a GoogleTest program and makes each of its suites one ctest, or each
# share of its tests. To start a program takes longer than most tests do; which test failed is said in its output.
cmake_minimum_required(VERSION 3.25)

# add_suites(PROGRAM PATTERN AS property value...)  PATTERN is GoogleTest's. AS is SUITES, which the pattern then takes
# whole, EACH_TEST, or the number of shares into which the tests are divided, one after the other.
function(add_suites program pattern as)
  set(names "")
  get_filename_component(program_name ${program} NAME)
  execute_process(COMMAND ${program} --gtest_list_tests --gtest_filter=${pattern} TIMEOUT 60
    OUTPUT_VARIABLE listed RESULT_VARIABLE status ERROR_QUIET)
  if(NOT status EQUAL 0)  # not built, or it cannot start: said by a ctest that fails
    add_test(${program_name}.cannot_be_started ${program} --gtest_list_tests)
    return()
  endif()
  if(as MATCHES "^[0-9]+$")
    math(EXPR last "${as} - 1")
    foreach(share RANGE ${last})
      math(EXPR number "${share} + 1")
      set(name ${program_name}.${number}_of_${as})
      add_test(${name} env GTEST_TOTAL_SHARDS=${as} GTEST_SHARD_INDEX=${share}
        ${program} --gtest_filter=${pattern})
      set_tests_properties(${name} PROPERTIES ${ARGN})
    endforeach()
    return()
  endif()
  string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # what a parameter is
  string(REGEX MATCHALL "[^\n]+" lines "${listed}")
  foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)[.]$")
      set(suite ${CMAKE_MATCH_1})
    elseif(NOT line MATCHES "^  DISABLED_" AND line MATCHES "^  (.+)$")
      if(as STREQUAL EACH_TEST)
        list(APPEND names ${suite}.${CMAKE_MATCH_1})
      else()
        list(APPEND names ${suite})
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES names)
  foreach(name IN LISTS names)
    set(filter ${name})
    if(as STREQUAL SUITES)
      set(filter ${name}.*)
    endif()
    add_test(${name} ${program} --gtest_filter=${filter})
    set_tests_properties(${name} PROPERTIES ${ARGN})
  endforeach()
endfunction()
