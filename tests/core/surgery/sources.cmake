target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/closing_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/collision_groups_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/face_blocks_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/many_fronts_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/mesh_edits_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/opening_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/plan_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/predicted_change_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/topology_adaptation_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/topology_events_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/touch_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/surgery/work_budget_test.cpp)
