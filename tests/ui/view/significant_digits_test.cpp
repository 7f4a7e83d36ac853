#include "ui/view/significant_digits.h"

#include "tests/support/catch.h"

using namespace handlebody::ui;

TEST_CASE("Numbers over the views are written out, with no more digits behind the point than tell something",
          "[numbers]") {
  const QLocale plain = QLocale::c();
  const auto written = [&](double value) { return significant(value, 4, plain).toStdString(); };
  CHECK(written(123456) == "123456");
  CHECK(written(-20000.4) == "-20000");
  CHECK(written(65535) == "65535");
  CHECK(written(1e14) == "100000000000000");
  CHECK(written(400) == "400");
  CHECK(written(12.3456) == "12.35");
  CHECK(written(9.99996) == "10");
  CHECK(written(0.00012) == "0.00012");
  CHECK(written(0) == "0");
}

TEST_CASE("Numbers that would be a row of zeros are powers of ten", "[numbers]") {
  CHECK(significant(2e20, 4, QLocale::c()) == "2e+20");
  CHECK(significant(-3e-9, 4, QLocale::c()) == "-3e-09");
}

TEST_CASE("Numbers over the views are in the user's language", "[numbers]") {
  const QLocale german(QLocale::German);
  CHECK(significant(12345.6, 3, german) == QStringLiteral("12.346"));
  CHECK(significant(0.25, 3, german) == QStringLiteral("0,25"));
}
