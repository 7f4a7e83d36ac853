target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/handles/cross_edges.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/disc_triangulation.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_bound.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_count.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_database.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_enumeration.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/handle_orbits.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/homology.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/listed_handles.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/partial_handle.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/smith_normal_form.cpp
  ${CMAKE_SOURCE_DIR}/core/handles/shortest_handles.cpp)

# The stored handles become a part of the library, so that the programs need no file at run time.
set(handle_database ${CMAKE_SOURCE_DIR}/resources/handles/handles.txt)
set(embed_handles ${CMAKE_SOURCE_DIR}/resources/handles/embed.cmake)
set(handle_database_text ${CMAKE_BINARY_DIR}/generated/handle_database_text.cpp)
add_custom_command(
  OUTPUT ${handle_database_text}
  COMMAND ${CMAKE_COMMAND} -DINPUT=${handle_database} -DOUTPUT=${handle_database_text} -P ${embed_handles}
  DEPENDS ${handle_database} ${embed_handles}
  VERBATIM)
target_sources(handlebody_core PRIVATE ${handle_database_text})
