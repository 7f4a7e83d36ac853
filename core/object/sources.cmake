target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/object/arrival.cpp
  ${CMAKE_SOURCE_DIR}/core/object/candidates.cpp
  ${CMAKE_SOURCE_DIR}/core/object/cells.cpp
  ${CMAKE_SOURCE_DIR}/core/object/closure.cpp
  ${CMAKE_SOURCE_DIR}/core/object/corrections.cpp
  ${CMAKE_SOURCE_DIR}/core/object/distance.cpp
  ${CMAKE_SOURCE_DIR}/core/object/expected_overlap.cpp
  ${CMAKE_SOURCE_DIR}/core/object/intensity_scale.cpp
  ${CMAKE_SOURCE_DIR}/core/object/morphology.cpp
  ${CMAKE_SOURCE_DIR}/core/object/object_model.cpp
  ${CMAKE_SOURCE_DIR}/core/object/rays.cpp
  ${CMAKE_SOURCE_DIR}/core/object/region.cpp
  ${CMAKE_SOURCE_DIR}/core/object/region_field.cpp
  ${CMAKE_SOURCE_DIR}/core/object/relabel.cpp
  ${CMAKE_SOURCE_DIR}/core/object/star_surface.cpp)
