# Read by ctest when it starts: lists the tests of a GoogleTest program and makes each of its suites one ctest. To start
# a program takes longer than most tests do; which test of a suite failed is said in its output.
cmake_minimum_required(VERSION 3.25)

# add_suites(PROGRAM PATTERN EACH_TEST property value...)  PATTERN is GoogleTest's, and takes whole suites. Where EACH_TEST
# is true, each test is a ctest, and the pattern may take some of a suite.
function(add_suites program pattern each_test)
  set(names "")
  execute_process(COMMAND ${program} --gtest_list_tests --gtest_filter=${pattern} TIMEOUT 60
    OUTPUT_VARIABLE listed RESULT_VARIABLE status ERROR_QUIET)
  if(NOT status EQUAL 0)  # not built, or it cannot start: said by a ctest that fails
    get_filename_component(name ${program} NAME)
    add_test(${name}.cannot_be_started ${program} --gtest_list_tests)
    return()
  endif()
  string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # what a parameter is
  string(REGEX MATCHALL "[^\n]+" lines "${listed}")
  foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)[.]$")
      set(suite ${CMAKE_MATCH_1})
    elseif(NOT line MATCHES "^  DISABLED_" AND line MATCHES "^  (.+)$")
      if(each_test)
        list(APPEND names ${suite}.${CMAKE_MATCH_1})
      else()
        list(APPEND names ${suite})
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES names)
  foreach(name IN LISTS names)
    set(filter ${name})
    if(NOT each_test)
      set(filter ${name}.*)
    endif()
    add_test(${name} ${program} --gtest_filter=${filter})
    set_tests_properties(${name} PROPERTIES ${ARGN})
  endforeach()
endfunction()
