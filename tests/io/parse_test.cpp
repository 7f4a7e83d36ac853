#include "core/io/report/parse.h"

#include <clocale>
#include <cmath>

#include "core/io/report/option_error.h"
#include "tests/support/catch.h"

using namespace handlebody;

TEST_CASE("numbers are read in every usual way of writing them", "[cli]") {
  CHECK(parseNumber("--x", "-1.5e2") == -150.0);
  CHECK(parseNumber("--x", "+2") == 2.0);
  CHECK(parseNumber("--x", ".5") == 0.5);
  CHECK(parseNumber("--x", " 7 ") == 7.0);
  CHECK(parseNumber("--x", "0.1") == 0.1);
  CHECK(std::isinf(parseNumber("--x", "-inf")));
}

TEST_CASE("what is not a number is refused by the option's name", "[cli]") {
  for (const char* text : {"", " ", "x", "1x", "1 2", "nan", "-nan", "--1", "+-1", "0x10", "1e999"}) {
    INFO(text);
    CHECK_THROWS_AS(parseNumber("--balloon", text), UsageError);
  }
  CHECK_THROWS_WITH(parseNumber("--balloon", "x"), Contains("--balloon"));
}

TEST_CASE("the error of an option says apart which option it is and what is wrong", "[cli]") {
  try {
    parseNumber("--balloon", "x");
    FAIL("it was taken");
  } catch (const OptionError& error) {
    CHECK(error.option() == "--balloon");
    CHECK(error.reason() == "'x' is not a number.");
    CHECK(error.what() == std::string("--balloon: 'x' is not a number."));
  }
}

TEST_CASE("a decimal point is a point in every locale", "[cli]") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(parseNumber("--x", "1.5") == 1.5);
  CHECK(parseSeed("--seed", "1.5,2.5,3.5").centre == Vec3(1.5, 2.5, 3.5));
  std::setlocale(LC_ALL, before.c_str());
  if (set == nullptr) WARN("SKIPPED: no German locale here; only the current one was tried");
}

TEST_CASE("whole numbers keep to their limits", "[cli]") {
  CHECK(parseInteger("--threads", "2", 1, 8) == 2);
  for (const char* text : {"0", "9", "1.5", "-1", "99999999999", ""}) {
    INFO(text);
    CHECK_THROWS_AS(parseInteger("--threads", text, 1, 8), UsageError);
  }
}

TEST_CASE("a range may be open at both ends but not empty", "[cli]") {
  const IntensityRange range = parseRange("--range", "-inf,inf");
  CHECK((std::isinf(range.low) && range.low < 0));
  CHECK((std::isinf(range.high) && range.high > 0));
  CHECK(parseRange("--range", "-5,-5").low == -5.0);
  for (const char* text : {"1", "2,1", "1,2,3", "1,", ",", "nan,1"}) {
    INFO(text);
    CHECK_THROWS_AS(parseRange("--range", text), UsageError);
  }
}

TEST_CASE("a seed has three finite coordinates and perhaps a radius above zero", "[cli]") {
  CHECK_FALSE(parseSeed("--seed", "-1,2,3").radius.has_value());
  const Seed seed = parseSeed("--seed", "-1,2,3,0.25");
  CHECK(seed.centre == Vec3(-1, 2, 3));
  CHECK(*seed.radius == 0.25);
  for (const char* text :
       {"1,2", "1,2,3,4,5", "1,2,3,0", "1,2,3,-1", "1,2,3,inf", "inf,2,3", "nan,2,3", "1,2,3,"}) {
    INFO(text);
    CHECK_THROWS_AS(parseSeed("--seed", text), UsageError);
  }
}
