#include "core/finding.h"

#include <regex>
#include <set>
#include <string>

#include "core/finding_words.h"
#include "core/told_error.h"
#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("every kind of finding has a name of its own and words", "[finding]") {
  std::set<std::string> names;
  for (int k = 0; k < kFindingKinds; ++k) {
    const auto kind = static_cast<FindingKind>(k);
    CAPTURE(k, findingName(kind));
    CHECK(names.insert(findingName(kind)).second);
    CHECK((kind == FindingKind::none || *findingText(kind) != 0));
    CHECK(std::regex_match(findingName(kind), std::regex("[a-z]+(-[a-z]+)*")));
  }
}

TEST_CASE("what stands in braces in the words of a finding is a name with a format", "[finding]") {
  const std::regex hole(R"(\{([a-z_]+(: ?[0-9][fgm])?|option:[a-z]+(-[a-z]+)*)\})");
  for (int k = 0; k < kFindingKinds; ++k) {
    const std::string text = findingText(static_cast<FindingKind>(k));
    CAPTURE(text);
    CHECK(std::regex_replace(text, hole, "").find_first_of("{}") == std::string::npos);
  }
}

TEST_CASE("the words of findings name options in braces alone", "[finding]") {
  const std::regex command(R"(\(handlebody-cli [^)]*\))");  // to be typed as it is, whoever tells it
  for (int k = 0; k < kFindingKinds; ++k) {
    const std::string text = findingText(static_cast<FindingKind>(k));
    CAPTURE(text);
    CHECK_FALSE(std::regex_search(std::regex_replace(text, command, ""), std::regex("--[a-z]")));
  }
}

TEST_CASE("who tells a finding says how its options are written", "[finding]") {
  const OptionSpelling shouted = [](std::string_view option) { return "<" + std::string(option) + ">"; };
  const Finding grown(FindingKind::stuck);
  CHECK_THAT(sentence(grown), Catch::Matchers::Contains("another --edge-length may help"));
  CHECK_THAT(sentence(grown, shouted), Catch::Matchers::Contains("another <edge-length> may help"));
  CHECK(sentences({grown}, shouted) == std::vector{sentence(grown, shouted)});
  const Finding chosen(FindingKind::fileRefused, {{"file", std::string("a --series.dcm")}},
                       FindingKind::severalToChoose);
  CHECK(sentence(chosen, shouted) ==
        "a --series.dcm: it holds several series or stacks, choose one with <series>.");
  const Finding asked(
      FindingKind::undecided,
      {{"iteration", 3}, {"spot", std::string("1,2,3.5")}, {"allow", std::string("--allow=")}},
      Finding(FindingKind::frontsWouldMeet, {{"place", std::array{1.0, 2.0, 3.5}}}));
  CHECK_THAT(sentence(asked), Catch::Matchers::EndsWith("; --allow=1,2,3.5 lets it happen, --hold=1,2,3.5 "
                                                        "holds it without asking again"));
  CHECK_THAT(sentence(asked, shouted), Catch::Matchers::Contains("; <allow>=1,2,3.5 lets it happen"));
}

TEST_CASE("a finding is told in English with its numbers", "[finding]") {
  CHECK(sentence(Finding(FindingKind::noEdge, {{"percent", 45.4}})).rfind("45 % of the surface", 0) == 0);
  CHECK(sentence(Finding(FindingKind::wallOverSeed, {{"place", std::array{1.5, -2.0, 3.25}}})) ==
        "A wall lies over the seed at 1.5,-2,3.25 mm.");
  CHECK(sentence(Finding(FindingKind::seedOutside,
                         {{"place", std::array{1.0, 2.0, 3.0}}, {"voxel", std::array{4.0, 5.0, 6.0}}})) ==
        "The seed at (1.000000, 2.000000, 3.000000) mm lies outside the volume (voxel 4.000000, 5.000000, "
        "6.000000).");
}

TEST_CASE("what a value says is not read as a place for another", "[finding]") {
  const Finding empty(FindingKind::fileRefused, {{"file", std::string("a {cause} of {file}.nii")}},
                      FindingKind::emptyFile);
  CHECK(sentence(empty) == "a {cause} of {file}.nii: the file is empty.");
}

TEST_CASE("a kind is found by its name", "[finding]") {
  for (int k = 0; k < kFindingKinds; ++k) {
    const auto kind = static_cast<FindingKind>(k);
    CHECK(findingKindOf(findingName(kind)) == kind);
  }
  CHECK(findingKindOf("no such kind") == FindingKind::none);
}

TEST_CASE("the cause of a finding is told within it", "[finding]") {
  const Finding rings(FindingKind::ringsAdded, {{"rings", 2}}, FindingKind::noHandle);
  CHECK(sentence(rings) == "2 rings added: no handle fits");
  CHECK(sentence(std::vector<Finding>{rings, FindingKind::maybeShorter}) ==
        "2 rings added: no handle fits; there may be a shorter handle");
}

TEST_CASE("the entries of a list are told one behind the other", "[finding]") {
  const auto run = [](FindingKind kind, int gaps, double mm) {
    return Finding(kind, {{"gaps", gaps}, {"gap_mm", mm}});
  };
  const std::vector<Finding> runs = {run(FindingKind::gapOf, 1, 4), run(FindingKind::nextGapsOf, 13, 1.08),
                                     run(FindingKind::nextGapsOfMore, 2, 7)};
  CHECK(sentence(Finding(FindingKind::slicesUneven, {}, runs)) ==
        "its slices are unevenly spaced (1 gap of 4 mm, 13 of 1.08 mm, 2 of 7 mm …)");
  const Finding one(FindingKind::brokenSeriesOfFile,
                    {{"series", std::string("1.2")}, {"what", std::string("CT Scout, ")}});
  const Finding other(FindingKind::seriesOfFiles, {{"series", std::string("1.3")},
                                                   {"what", std::string()},
                                                   {"files", 20},
                                                   {"size", std::string("256 x 256 x 20")},
                                                   {"spacing_mm", std::array{0.9, 0.9, 5.0}}});
  CHECK(sentence(Finding(
            FindingKind::nothingChosen, {},
            Finding(FindingKind::seriesToChoose, {{"series", 2}}, std::vector<Finding>{one, other}))) ==
        "Nothing is chosen: it holds 2 series or stacks, choose one with --series: 1.2 (CT Scout, 1 file, no "
        "volume); 1.3 (20 files, 256 x 256 x 20 voxels of 0.9, 0.9, 5 mm).");
}

TEST_CASE("an error says its finding and keeps it", "[finding]") {
  const Told<UsageError> error(Finding(FindingKind::vetoTooLate, {{"iteration", 3}, {"now", 7}}));
  CHECK(std::string(error.what()) ==
        "The veto of iteration 3 comes too late: the surface is at iteration 7.");
  CHECK(error.finding().kind == FindingKind::vetoTooLate);
  CHECK(error.finding().number("now") == 7);
  CHECK(findingOf(static_cast<const UsageError&>(error)).kind == FindingKind::vetoTooLate);
  CHECK_FALSE(findingOf(UsageError("words alone")).any());
  CHECK(saidBy(static_cast<const UsageError&>(error)).kind == FindingKind::vetoTooLate);
  CHECK(saidBy(UsageError("words alone")).kind == FindingKind::other);
  CHECK(sentence(saidBy(UsageError("words alone"))) == "words alone");
}

TEST_CASE("a number that no place can have is told with an exponent", "[finding]") {
  const Finding far(FindingKind::seedOutside,
                    {{"place", std::array{1e300, 20.0, -2e15}}, {"voxel", std::array{1e300, 1.0, 2.0}}});
  CHECK_THAT(sentence(far), Catch::Matchers::Contains("(1e+300, 20.000000, -2e+15) mm"));
}
