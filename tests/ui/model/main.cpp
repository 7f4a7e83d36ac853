// Catch2 inside a Qt application without a window; its data folder is a temporary one.

#include <QCoreApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/support/run_catch.h"

int main(int argc, char** argv) {
  const QTemporaryDir home;
  if (qEnvironmentVariableIsEmpty("HANDLEBODY_TEST_DATA")) qputenv("XDG_DATA_HOME", home.path().toUtf8());
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName(QStringLiteral("handlebody-tests"));
  return handlebody::test::runCatch(argc, argv);
}
