# Reports and sessions: JSON only, neither ITK nor VTK.
find_package(nlohmann_json REQUIRED)
add_library(handlebody_report STATIC
  ${CMAKE_SOURCE_DIR}/core/io/json.cpp
  ${CMAKE_SOURCE_DIR}/core/io/parameter_names.cpp
  ${CMAKE_SOURCE_DIR}/core/io/report.cpp
  ${CMAKE_SOURCE_DIR}/core/io/session.cpp)
target_link_libraries(handlebody_report PUBLIC handlebody_core handlebody_io PRIVATE nlohmann_json::nlohmann_json)
