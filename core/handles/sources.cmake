target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/handles/cross_edges.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/disc_triangulation.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_bound.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_count.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_enumeration.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_orbits.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/homology.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/smith_normal_form.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/shortest_handles.cpp)
