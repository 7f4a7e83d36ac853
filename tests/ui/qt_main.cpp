// The main function of tests that need a QApplication, and so a platform to show windows on.
#include <QApplication>

#include "tests/support/run_catch.h"

int main(int argc, char** argv) {
  int qtArguments = 1;  // the others are for Catch2
  QApplication app(qtArguments, argv);
  return handlebody::test::runCatch(argc, argv);
}
