target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/measure/ball_path.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/centre_line.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/farthest_pair.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/inscribed_balls.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/intensity_inside.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/measurement.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/object_measures.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/section_area.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/shape_measures.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/surface_gap.cpp
  ${CMAKE_SOURCE_DIR}/core/measure/wall_thickness.cpp)
