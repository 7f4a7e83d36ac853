target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/mesh_test.cpp)
