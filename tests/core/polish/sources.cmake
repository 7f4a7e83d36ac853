target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/polish/cover_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/polish/polish_test.cpp)
