target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/sequence/carried_seeds.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/cycle_check.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/drift.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/frame_motion.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/moved_object.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/over_time.cpp
  ${CMAKE_SOURCE_DIR}/core/sequence/volume_curve.cpp)
