target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/mesh/validity.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/mesh.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/pieces.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/containment.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/tunnels.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/tree_cotree.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/loop_tightening.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/loop_search.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/linking.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/loop_classes.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/morton_order.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/nesting.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/plane_section.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/remesh.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/shapes.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/structure.cpp
  ${CMAKE_SOURCE_DIR}/core/mesh/topology.cpp)
