// The main function of tests that need a QApplication, and so a platform to show windows on.
#include <QApplication>

#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

int main(int argc, char** argv) {
  int qtArguments = 1;  // the others are for Catch2
  QApplication app(qtArguments, argv);
  return Catch::Session().run(argc, argv);
}
