// The way from one of the objects that the clicks may mean to the next smaller or larger one.

#include "ui/model/candidate_choice.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

CandidateChoice choiceOf(std::initializer_list<double> volumes, int chosen) {
  CandidateChoice choice;
  for (double volume : volumes) {
    choice.candidates.emplace_back();
    choice.candidates.back().volume = volume;
  }
  choice.chosen = chosen;
  return choice;
}

}  // namespace

TEST_CASE("smaller and larger go by volume, not by what is likely", "[candidates]") {
  const CandidateChoice choice = choiceOf({20, 5, 90, 10}, 1);
  CHECK(neighbour(choice, SizeStep::smaller) == 4);
  CHECK(neighbour(choice, SizeStep::larger) == 3);
  CHECK(placeBySize(choice) == 3);
}

TEST_CASE("there is nothing smaller than the smallest and nothing larger than the largest", "[candidates]") {
  CHECK_FALSE(neighbour(choiceOf({20, 5, 90}, 2), SizeStep::smaller));
  CHECK_FALSE(neighbour(choiceOf({20, 5, 90}, 3), SizeStep::larger));
}

TEST_CASE("without candidates, or with one, there is nowhere to go", "[candidates]") {
  for (const CandidateChoice& choice : {choiceOf({}, 0), choiceOf({7}, 1)})
    for (SizeStep step : {SizeStep::smaller, SizeStep::larger}) CHECK_FALSE(neighbour(choice, step));
  CHECK(placeBySize(choiceOf({}, 0)) == 0);
}

TEST_CASE("steps upwards come to every candidate once, and steps downwards back", "[candidates]") {
  CandidateChoice choice = choiceOf({20, 5, 20, 90, 20}, 2);
  std::vector<int> up{2}, down;
  while (const auto next = neighbour(choice, SizeStep::larger)) up.push_back(choice.chosen = *next);
  CHECK(up == std::vector{2, 1, 3, 5, 4});
  for (std::size_t i = 0; i < up.size(); ++i) {
    choice.chosen = up[i];
    CHECK(placeBySize(choice) == static_cast<int>(i) + 1);
  }
  while (const auto next = neighbour(choice, SizeStep::smaller)) down.push_back(choice.chosen = *next);
  CHECK(down == std::vector{5, 3, 1, 2});
}
