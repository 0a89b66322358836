# Adds a test that checks robot descriptions with sdfcheck.
#
#   ament_sdfcheck([paths…] [TESTNAME name] [CONFIG_FILE file] [EXCLUDE paths…] [ARGUMENTS options…])
#
# Without paths all descriptions of the package are checked. TESTNAME is `sdfcheck` unless given;
# ARGUMENTS are options of `sdfcheck lint`.
function(ament_sdfcheck)
  cmake_parse_arguments(ARG "" "TESTNAME;CONFIG_FILE" "EXCLUDE;ARGUMENTS" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "sdfcheck")
  endif()

  find_program(ament_sdfcheck_BIN NAMES "ament_sdfcheck")
  if(NOT ament_sdfcheck_BIN)
    message(FATAL_ERROR "ament_sdfcheck(): the program `ament_sdfcheck` is not found")
  endif()

  set(result_file "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_sdfcheck_BIN}" "--xunit-file" "${result_file}")
  if(ARG_CONFIG_FILE)
    list(APPEND command "--config" "${ARG_CONFIG_FILE}")
  endif()
  list(APPEND command ${ARG_ARGUMENTS})
  if(ARG_UNPARSED_ARGUMENTS)
    list(APPEND command ${ARG_UNPARSED_ARGUMENTS})
  else()
    list(APPEND command ".")
  endif()
  if(ARG_EXCLUDE)
    list(APPEND command "--exclude" ${ARG_EXCLUDE})
  endif()

  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/ament_sdfcheck")
  ament_add_test(
    "${ARG_TESTNAME}"
    COMMAND ${command}
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_sdfcheck/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "sdfcheck;linter")
endfunction()
