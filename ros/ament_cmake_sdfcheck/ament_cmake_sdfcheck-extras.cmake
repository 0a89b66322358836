find_package(ament_cmake_test QUIET REQUIRED)

include("${ament_cmake_sdfcheck_DIR}/ament_sdfcheck.cmake")

ament_register_extension(
  "ament_lint_auto"
  "ament_cmake_sdfcheck"
  "ament_cmake_sdfcheck_lint_hook.cmake"
)
