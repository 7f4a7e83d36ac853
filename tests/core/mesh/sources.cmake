target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/plane_section_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/mesh_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/mesh_copy_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/morton_order_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/nesting_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/remesh_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/smaller_components_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/structure_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/topology_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/mesh/tunnels_test.cpp)
