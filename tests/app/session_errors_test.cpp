// What is no session, or has something wrong in it.

#include "core/io/report/session.h"
#include "core/told_error.h"
#include "tests/app/session_support.h"

using namespace handlebody;
using namespace handlebody::test;

namespace {

//! FindingKind::none if nothing is.
Finding whatIsWrong(const std::string& session) try {
  readSession(session);
  return {};
} catch (const InputError& error) {
  CHECK_THAT(error.what(), Contains(session));
  return findingOf(error);
}

}  // namespace

TEST_CASE("what is not a session is an input error that names the file", "[session]") {
  using Edit = void (*)(nlohmann::json&);
  const Edit edits[] = {
      [](nlohmann::json& j) { j = nlohmann::json::array(); },
      [](nlohmann::json& j) { j = 5; },
      [](nlohmann::json& j) { j.erase("version"); },
      [](nlohmann::json& j) { j.erase("input"); },
      [](nlohmann::json& j) { j["input"] = "v.mha"; },
      [](nlohmann::json& j) { j["input"]["path"] = 7; },
      [](nlohmann::json& j) { j["input"].erase("sha256"); },
      [](nlohmann::json& j) { j["input"]["sha256"] = ""; },
      [](nlohmann::json& j) { j["input"]["frame"] = "first"; },
      [](nlohmann::json& j) { j["input"]["frame"] = -1; },
      [](nlohmann::json& j) { j["input"]["frame"] = 0.5; },
      [](nlohmann::json& j) { j.erase("requested"); },
      [](nlohmann::json& j) { j["requested"].erase("seeds"); },
      [](nlohmann::json& j) { j["requested"]["seeds"] = nlohmann::json::array(); },
      [](nlohmann::json& j) { j["requested"]["seeds"] = 3; },
      [](nlohmann::json& j) {
        j["requested"]["seeds"][0]["centre"] = {1, 2};
      },
      [](nlohmann::json& j) {
        j["requested"]["seeds"][0]["centre"] = {1, 2, 3, 4};
      },
      [](nlohmann::json& j) {
        j["requested"]["seeds"][0]["centre"] = {1, 2, nullptr};
      },
      [](nlohmann::json& j) { j["requested"]["object"] = "grey"; },
      [](nlohmann::json& j) { j["requested"]["object"] = 1; },
      [](nlohmann::json& j) { j["requested"]["direction"] = "inward"; },
      [](nlohmann::json& j) { j["requested"]["space"] = "MNI"; },
      [](nlohmann::json& j) {
        j["requested"]["range"] = {1, 2, 3};
      },
      [](nlohmann::json& j) {
        j["requested"]["range"] = {"low", 2};
      },
      [](nlohmann::json& j) { j["requested"]["balloon"] = "strong"; },
      [](nlohmann::json& j) { j["requested"]["balloon"] = true; },
      [](nlohmann::json& j) { j["requested"]["seeds"][2]["background"] = "yes"; },
      [](nlohmann::json& j) { j["requested"]["seeds"][2]["background"] = 1; },
      [](nlohmann::json& j) { j["requested"]["seeds"][2]["background"] = nullptr; },
      [](nlohmann::json& j) {
        for (auto& seed : j["requested"]["seeds"]) seed["background"] = true;
      },
      [](nlohmann::json& j) { j["requested"]["candidate"] = 0; },
      [](nlohmann::json& j) { j["requested"]["candidate"] = -1; },
      [](nlohmann::json& j) { j["requested"]["candidate"] = 1.5; },
      [](nlohmann::json& j) { j["requested"]["candidate"] = true; },
      [](nlohmann::json& j) { j["requested"]["candidate"] = "first"; },
      [](nlohmann::json& j) { j["requested"]["candidate"] = nullptr; },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["candidate"] = 0; },
      [](nlohmann::json& j) { j["requested"]["max_iterations"] = 1.5; },
      [](nlohmann::json& j) { j["requested"]["threads"] = 1e12; },
      [](nlohmann::json& j) { j["requested"]["broad_phase"] = "guessing"; },
      [](nlohmann::json& j) { j["requested"]["broad_phase"] = 1; },
      [](nlohmann::json& j) { j["requested"]["resolution"] = "fine"; },
      [](nlohmann::json& j) { j["requested"]["threads"] = 4294967297; },
      [](nlohmann::json& j) { j["requested"]["stop_at"] = -1; },
      [](nlohmann::json& j) { j["requested"]["stop_at"] = "end"; },
      [](nlohmann::json& j) { j["requested"]["changes"] = 3; },
      [](nlohmann::json& j) { j["requested"]["changes"] = nlohmann::json::object(); },
      [](nlohmann::json& j) { j["requested"]["changes"][0].erase("iteration"); },
      [](nlohmann::json& j) { j["requested"]["changes"][0]["iteration"] = -1; },
      [](nlohmann::json& j) { j["requested"]["changes"][0]["iteration"] = 9; },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["object"] = "grey"; },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["seeds"] = nlohmann::json::array(); },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["seeds"] = 3; },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["seeds"] = nullptr; },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["seeds"][0].erase("centre"); },
      [](nlohmann::json& j) { j["requested"]["changes"][1]["seeds"][0]["background"] = true; },
  };
  const TempFolder folder;
  int number = 0;
  for (Edit edit : edits) {
    INFO("edit " << number++);
    nlohmann::json json = validJson();
    edit(json);
    test::writeBytes(folder / "s.json", json.dump());
    const Finding told = whatIsWrong(folder / "s.json");
    CHECK(told.kind == FindingKind::notASession);
    CHECK(std::get<std::string>(*told.find("file")) == folder / "s.json");
    REQUIRE(told.causes.size() == 1);
    CHECK(told.causes[0].kind != FindingKind::other);
  }
}

TEST_CASE("what is wrong in a session is told by its kind and its place", "[session]") {
  const TempFolder folder;
  const auto wrong = [&folder](const char* place, const nlohmann::json& value) {
    nlohmann::json json = validJson();
    json[nlohmann::json::json_pointer(place)] = value;
    test::writeBytes(folder / "s.json", json.dump());
    return whatIsWrong(folder / "s.json").causes.at(0);
  };
  const auto check = [](const Finding& told, FindingKind kind, const std::string& sentenceOfIt) {
    CHECK(told.kind == kind);
    CHECK(sentence(told) == sentenceOfIt);
  };
  check(wrong("/requested/constraints/walls/0", {{"centre", {1, 2, 3}}}), FindingKind::fieldMissing,
        "it has no field 'requested.constraints.walls[0].radius'.");
  check(wrong("/requested/constraints/walls/0/radius", 0), FindingKind::fieldNotAbove,
        "its field 'requested.constraints.walls[0].radius' is 0, and must be above 0.");
  check(wrong("/requested/seeds/1/centre", {1, 2}), FindingKind::fieldEntries,
        "its field 'requested.seeds[1].centre' must have 3 entries; it has 2.");
  check(wrong("/requested/seeds/1/centre/2", false), FindingKind::fieldNotNumber,
        "its field 'requested.seeds[1].centre[2]' is false, not a number.");
  check(wrong("/requested/changes/2/iteration", 9), FindingKind::fieldNotAscending,
        "its field 'requested.changes[2].iteration' is not above that of the entry before it.");
  check(wrong("/requested/object", "grey"), FindingKind::fieldUnknownWord,
        "its field 'requested.object' is 'grey', a word that this version does not know.");
  check(wrong("/requested/object", std::string(200, '\n')), FindingKind::fieldUnknownWord,
        "its field 'requested.object' is '" + std::string(64, '?') +
            "', a word that this version does not know.");
  check(wrong("/requested/constraints", 3), FindingKind::fieldNotObject,
        "its field 'requested.constraints' is not a JSON object.");
  check(wrong("/requested/constraints/vetoes/0/iteration", 0), FindingKind::fieldBelow,
        "its field 'requested.constraints.vetoes[0].iteration' is 0, and must be at least 1.");
  check(wrong("/input/sha256", ""), FindingKind::fieldEmpty, "its field 'input.sha256' is empty.");
  check(wrong("/measurements", {{{"kind", "ruler"}, {"points", {{1, 2, 3}}}}}), FindingKind::fieldEntries,
        "its field 'measurements[0].points' must have 2 entries; it has 1.");

  test::writeBytes(folder / "s.json", "[]");
  CHECK(whatIsWrong(folder / "s.json").causes.at(0).kind == FindingKind::fieldMissing);
  test::writeBytes(folder / "s.json", R"({"version": 1e999})");
  CHECK(whatIsWrong(folder / "s.json").causes.at(0).kind == FindingKind::jsonNumberTooLarge);
}

TEST_CASE("a label and a growth over time without sense are told by their places", "[session]") {
  const TempFolder folder;
  Session s = unusualSession(folder / "v.mha");
  s.label = {"One", {1, 2, 3}, 4, "liver"};
  s.overTime.emplace();
  s.overTime->frames = {2, 5};
  writeSession(s, folder / "valid.json");
  REQUIRE_NOTHROW(readSession(folder / "valid.json"));
  const auto valid = nlohmann::json::parse(test::readBytes(folder / "valid.json"));
  const auto wrong = [&](const char* place, const nlohmann::json& value) {
    nlohmann::json json = valid;
    json[nlohmann::json::json_pointer(place)] = value;
    test::writeBytes(folder / "s.json", json.dump());
    const Finding told = whatIsWrong(folder / "s.json").causes.at(0);
    INFO(sentence(told));
    CHECK(told.find("field") != nullptr);
    return told.kind;
  };
  CHECK(wrong("/requested/label/name", "") == FindingKind::fieldNoName);
  CHECK(wrong("/requested/label/name", "a|b") == FindingKind::fieldNoName);
  CHECK(wrong("/requested/label/term", "soul") == FindingKind::fieldUnknownWord);
  CHECK(wrong("/requested/label/value", 0) == FindingKind::fieldOutside);
  CHECK(wrong("/requested/label/value", 65536) == FindingKind::fieldOutside);
  CHECK(wrong("/requested/label/colour", {1, 2}) == FindingKind::fieldEntries);
  CHECK(wrong("/requested/label/colour/0", 256) == FindingKind::fieldOutside);
  CHECK(wrong("/over_time/frames", 3) == FindingKind::fieldNotList);
  CHECK(wrong("/over_time/frames", {5, 2}) == FindingKind::fieldNoRange);
  CHECK(wrong("/over_time/frames", {-1, 2}) == FindingKind::fieldBelow);
  CHECK(wrong("/over_time/topology", "loose") == FindingKind::fieldUnknownWord);
  CHECK(wrong("/over_time/drift_check", 1) == FindingKind::fieldNotText);
  CHECK(wrong("/over_time/given_frame_time_ms", 0) == FindingKind::fieldNotAbove);
}

TEST_CASE("bytes that are not JSON are an input error", "[session]") {
  const TempFolder folder;
  for (const std::string text : {"", "{", "hello", "\xff\xfe", "{\"version\": NaN}"}) {
    INFO(text);
    test::writeBytes(folder / "s.json", text);
    CHECK_THROWS_AS(readSession(folder / "s.json"), InputError);
  }
  CHECK_THROWS_AS(readSession(folder / "missing.json"), InputError);
  CHECK_THROWS_AS(readSession(folder.path()), InputError);
}

TEST_CASE("a constraint that is not known is refused by its name, not dropped", "[session]") {
  const TempFolder folder;
  auto json = validJson();
  auto& constraints = json["requested"]["constraints"];
  constraints["wals"] = constraints["walls"];
  constraints.erase("walls");
  test::writeBytes(folder / "s.json", json.dump());
  CHECK_THROWS_WITH(
      readSession(folder / "s.json", {}),
      Catch::Matchers::Contains("s.json") && Catch::Matchers::Contains("'requested.constraints.wals'"));
}

TEST_CASE("a parameter that is not known is refused by its name, not dropped", "[session]") {
  const TempFolder folder;
  auto json = validJson();
  json["requested"]["edge_lenght"] = 2;
  test::writeBytes(folder / "s.json", json.dump());
  CHECK_THROWS_WITH(
      readSession(folder / "s.json", {}),
      Catch::Matchers::Contains("s.json") && Catch::Matchers::Contains("'requested.edge_lenght'"));
}
