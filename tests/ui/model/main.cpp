// Catch2 inside a Qt application without a window; its data folder is a temporary one.

#include <QCoreApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

int main(int argc, char** argv) {
  const QTemporaryDir home;
  if (qEnvironmentVariableIsEmpty("HANDLEBODY_TEST_DATA")) qputenv("XDG_DATA_HOME", home.path().toUtf8());
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName(QStringLiteral("handlebody-tests"));
  return Catch::Session().run(argc, argv);
}
