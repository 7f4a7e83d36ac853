#include "core/io/report/report.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "core/volume/intensity_statistics.h"
#include "tests/support/catch.h"

using namespace handlebody;

namespace {

RunReport smallReport() {
  RunReport r;
  r.session.version = "1.2.3";
  r.session.volume = {"v.mha", "00ff", {}};
  r.session.seeds = {{{1, 2, 3}, {}}};
  ResolvedParameters resolved;
  resolved.range = {-std::numeric_limits<double>::infinity(), 0.1};
  resolved.seeds = {{{1, 2, 3}, 4.5}};
  r.session.resolved = resolved;
  r.volume.grid.size = {3, 4, 5};
  r.volume.grid.direction << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  r.stopped = StopReason::converged;
  Event event;
  event.kind = EventKind::handleInserted;
  event.fronts = 2;
  event.loopSizes = {5, 6};
  event.trace.boundaryLoops = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  r.events = {event};
  return r;
}

}  // namespace

TEST_CASE("a report holds every field of the contract", "[report]") {
  const auto json = nlohmann::json::parse(reportText(smallReport()));
  for (const char* key :
       {"version", "notice", "input", "parameters", "requested", "seeds", "candidates", "close_choice",
        "unsupported_surface", "iterations", "stopped", "seconds", "mesh", "handles", "events"}) {
    INFO(key);
    CHECK(json.contains(key));
  }
  for (const char* key : {"path", "sha256", "size", "spacing", "origin", "direction"})
    CHECK(json["input"].contains(key));
  for (const char* key : {"object", "range", "smoothing", "edge_length", "direction", "balloon", "curvature",
                          "max_iterations", "threads"}) {
    INFO(key);
    CHECK(json["parameters"].contains(key));
    CHECK(json["requested"].contains(key));
  }
  for (const char* key : {"load", "prepare", "evolve", "export", "total"})
    CHECK(json["seconds"].contains(key));
  for (const char* key : {"vertices", "faces", "components", "genus", "euler", "volume_mm3", "area_mm2",
                          "closed", "manifold", "oriented", "self_intersections"})
    CHECK(json["mesh"].contains(key));
  for (const char* key :
       {"kind", "iteration", "location", "fronts", "loop_sizes", "before", "after", "reason"})
    CHECK(json["events"][0].contains(key));
  for (const char* key : {"components", "genus", "euler"}) CHECK(json["events"][0]["before"].contains(key));
}

TEST_CASE("it is told how many handles came from the database and how many from the search", "[report]") {
  RunReport report = smallReport();
  report.events.resize(6);
  for (const std::size_t i : {1, 4}) report.events[i].handleFrom = HandleSource::database;
  report.events[5].handleFrom = HandleSource::search;
  const auto json = nlohmann::json::parse(reportText(report));
  CHECK(json.at("handles") == nlohmann::json{{"from_database", 2}, {"from_search", 1}});
  CHECK_FALSE(json.at("events").at(0).contains("handle_from"));
  CHECK(json.at("events").at(1).at("handle_from") == "database");
  CHECK(json.at("events").at(5).at("handle_from") == "search");
}

TEST_CASE("what is told of a result and of an event has a kind, its numbers and a sentence", "[report]") {
  RunReport report = smallReport();
  report.warnings = {{FindingKind::noEdge, {{"percent", 45.4}}}, FindingKind::liesInWall};
  report.events[0].reasons = {{FindingKind::ringsAdded, {{"rings", 2}}, FindingKind::noHandle},
                              FindingKind::maybeShorter};
  const auto json = nlohmann::json::parse(reportText(report));
  const auto& findings = json.at("findings");
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].at("kind") == "no-edge");
  CHECK(findings[0].at("percent") == 45.4);
  CHECK(findings[1].at("kind") == "lies-in-wall");
  for (std::size_t i = 0; i < 2; ++i) CHECK(findings[i].at("sentence") == json.at("warnings").at(i));
  const auto& event = json.at("events").at(0);
  CHECK(event.at("reason") == "2 rings added: no handle fits; there may be a shorter handle");
  CHECK(event.at("reasons").at(0).at("cause").at("kind") == "no-handle");
  CHECK(event.at("reasons").at(0).at("rings") == 2);
  CHECK(event.at("reasons").at(1).at("kind") == "maybe-shorter");
}

TEST_CASE("a report says what was used and what was asked for", "[report]") {
  const auto json = nlohmann::json::parse(reportText(smallReport()));
  CHECK(json["parameters"]["range"] == nlohmann::json::array({"-inf", 0.1}));
  CHECK(json["requested"]["range"].is_null());
  CHECK(json["seeds"][0]["radius"] == 4.5);
  CHECK(json["requested"]["seeds"][0]["radius"].is_null());
  CHECK(json["stopped"] == "converged");
}

TEST_CASE("a report names the candidate that grew", "[report]") {
  RunReport report = smallReport();
  CHECK(nlohmann::json::parse(reportText(report))["parameters"]["candidate"] == 1);
  report.session.resolved->candidate = 2;
  report.session.requested.candidate = 2;
  const auto json = nlohmann::json::parse(reportText(report));
  CHECK(json["parameters"]["candidate"] == 2);
  CHECK(json["requested"]["candidate"] == 2);
}

TEST_CASE("a report keeps clicks in the background apart from where the surface started", "[report]") {
  RunReport report = smallReport();
  CHECK_FALSE(nlohmann::json::parse(reportText(report)).contains("background"));
  const std::vector<Seed> background{{{7, 8, 9}, 2.5, true}, {{0, 0, 1}, {}, true}};
  for (std::vector<Seed>* seeds : {&report.session.seeds, &report.session.resolved->seeds})
    seeds->insert(seeds->end(), background.begin(), background.end());
  const auto json = nlohmann::json::parse(reportText(report));
  CHECK(json["seeds"] == nlohmann::json::parse(R"([{"centre": [1, 2, 3], "radius": 4.5}])"));
  CHECK(json["background"] ==
        nlohmann::json::parse(R"([{"centre": [7, 8, 9], "radius": 2.5}, {"centre": [0, 0, 1]}])"));
  CHECK(json["requested"]["seeds"].size() == 3);
  CHECK(json["requested"]["seeds"][1]["background"] == true);
}

TEST_CASE("a report lists the objects that the clicks may mean", "[report]") {
  RunReport report = smallReport();
  CHECK(nlohmann::json::parse(reportText(report))["candidates"] == nlohmann::json::array());
  CHECK(nlohmann::json::parse(reportText(report))["close_choice"] == false);
  report.candidates = {{4500, 0, -std::numeric_limits<double>::infinity(), 80, 1.5},
                       {12250, 2.5, 10, 90, 1.25}};
  report.candidates[1].high = std::numeric_limits<double>::infinity();
  report.isCloseChoice = true;
  report.session.resolved->candidate = 2;
  const auto json = nlohmann::json::parse(reportText(report));
  CHECK(json["close_choice"] == true);
  CHECK(json["candidates"] == nlohmann::json::parse(R"([
    {"index": 1, "volume_ml": 4.5, "neck_radius_mm": 0, "range": [null, 80], "score": 1.5, "chosen": false},
    {"index": 2, "volume_ml": 12.25, "neck_radius_mm": 2.5, "range": [10, null], "score": 1.25, "chosen": true}
  ])"));
}

TEST_CASE("the direction matrix is written row by row", "[report]") {
  const auto json = nlohmann::json::parse(reportText(smallReport()));
  CHECK(json["input"]["direction"][0] == nlohmann::json::array({0.0, -1.0, 0.0}));
  CHECK(json["input"]["direction"][1] == nlohmann::json::array({1.0, 0.0, 0.0}));
}

TEST_CASE("traces are in the trace file only", "[report]") {
  const RunReport report = smallReport();
  CHECK_FALSE(nlohmann::json::parse(reportText(report))["events"][0].contains("trace"));
  const auto trace = nlohmann::json::parse(traceText(report))["events"][0]["trace"];
  CHECK(trace["boundary_loops"][0][1] == nlohmann::json::array({1.0, 0.0, 0.0}));
  for (const char* key :
       {"colliding_faces", "lambda", "refined_faces", "opened_faces", "handle_faces", "closed_faces"})
    CHECK(trace[key].is_array());
}

TEMPLATE_TEST_CASE("percentiles are values at their rank", "[volume]", std::uint8_t, std::int8_t,
                   std::uint16_t, std::int16_t, std::int32_t, float, double) {
  constexpr VoxelType kType = std::is_same_v<TestType, std::uint8_t>    ? VoxelType::uint8
                              : std::is_same_v<TestType, std::int8_t>   ? VoxelType::int8
                              : std::is_same_v<TestType, std::uint16_t> ? VoxelType::uint16
                              : std::is_same_v<TestType, std::int16_t>  ? VoxelType::int16
                              : std::is_same_v<TestType, std::int32_t>  ? VoxelType::int32
                              : std::is_same_v<TestType, float>         ? VoxelType::float32
                                                                        : VoxelType::float64;
  Grid grid;
  grid.size = {101, 1, 1};
  void* buffer = nullptr;
  const Volume volume = makeVolume(grid, kType, &buffer);
  const int lowest = std::is_signed_v<TestType> ? -50 : 0;
  for (int i = 0; i <= 100; ++i)  // 37 and 101 have no common factor: a permutation of 101 values in a row
    static_cast<TestType*>(buffer)[i] = static_cast<TestType>(lowest + i * 37 % 101);
  const std::array percents{0.0, 1.0, 50.0, 99.9, 100.0};
  const IntensityStatistics s = intensityStatistics(volume, percents);
  CHECK(s.minimum == lowest);
  CHECK(s.maximum == lowest + 100);
  CHECK(s.mean == Approx(lowest + 50));
  CHECK(s.percentiles ==
        std::vector<double>{lowest + 0., lowest + 1., lowest + 50., lowest + 99., lowest + 100.});
}
