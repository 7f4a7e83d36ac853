target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/polish/cover.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/face_grid.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/patch.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/patch_search.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/polish.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/polished_surface.cpp
  ${CMAKE_SOURCE_DIR}/core/polish/shape.cpp)
