#include "ui/model/newest_job.h"

#include "tests/support/catch.h"
#include "ui/model/jobs_under_way.h"

using namespace handlebody::ui;

TEST_CASE("of jobs of one kind only the newest is awaited, and only until it was cancelled or has ended") {
  NewestJob jobs;
  jobs.cancel();  // there is none
  CHECK(jobs.number() == 0);
  CHECK_FALSE(jobs.isUnderWay());
  const StopFlag first = jobs.begin();
  const int number = jobs.number();
  CHECK(jobs.isAwaited(number));
  const StopFlag second = jobs.begin();
  CHECK_FALSE(jobs.isAwaited(number));
  CHECK(jobs.isAwaited(jobs.number()));
  CHECK_FALSE(*first);  // it goes on: who wants it stopped cancels it before
  jobs.cancel();
  CHECK(*second);
  CHECK_FALSE(*first);
  CHECK_FALSE(jobs.isAwaited(jobs.number()));
  const StopFlag third = jobs.begin();
  CHECK_FALSE(*third);
  jobs.end();
  CHECK_FALSE(jobs.isUnderWay());
  CHECK_FALSE(*third);
}

TEST_CASE("of jobs that all count all that are under way are cancelled together") {
  JobsUnderWay jobs;
  jobs.cancel();  // there is none
  const StopFlag ended = jobs.begin(), first = jobs.begin(), second = jobs.begin();
  CHECK_FALSE((*ended || *first || *second));
  jobs.end(ended);
  jobs.cancel();
  CHECK_FALSE(*ended);
  CHECK((*first && *second));
  CHECK_FALSE(*jobs.begin());
  jobs.end(first);
  jobs.end(first);  // is not under way any more
}
