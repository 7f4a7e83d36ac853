target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/handles/handle_count.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_enumeration.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_orbits.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/homology.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/smith_normal_form.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/two_front_handle.cpp)
