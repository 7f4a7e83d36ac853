target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/volume/anatomy.cpp
  ${CMAKE_SOURCE_DIR}/core/volume/border_region.cpp
  ${CMAKE_SOURCE_DIR}/core/volume/field_of_view.cpp
  ${CMAKE_SOURCE_DIR}/core/volume/smoothed_volume.cpp
  ${CMAKE_SOURCE_DIR}/core/volume/intensity_statistics.cpp
  ${CMAKE_SOURCE_DIR}/core/volume/volume.cpp)
