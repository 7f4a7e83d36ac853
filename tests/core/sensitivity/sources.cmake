target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/sensitivity/sensitivity_test.cpp)
