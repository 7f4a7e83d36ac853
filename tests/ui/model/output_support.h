#pragma once
// A Document whose files are waited for, the command line, and a program that is killed at work.

#include <QProcess>
#include <QProcessEnvironment>

#include "tests/ui/model/document_support.h"

namespace handlebody::ui {

//! A torus is open; what is written and what fails is kept.
struct OutputWork {
  TorusFile torus;
  Document document;
  QString failed;
  QStringList written;

  OutputWork() {
    const auto fail = [this](const QString& sentence) { failed = sentence; };
    const auto done = [this](const QString& path) { written.append(path); };
    QObject::connect(&document, &Document::exportFailed, fail);
    QObject::connect(&document, &Document::exportRefused, fail);
    QObject::connect(&document, &Document::saveFailed, fail);
    QObject::connect(&document, &Document::refused, fail);
    QObject::connect(&document, &Document::exported, done);
    QObject::connect(&document, &Document::sessionSaved, done);
    REQUIRE(openAndWait(document, torus.path));
  }
  bool isWritten(const QString& path) {
    return waitFor([&] { return written.contains(path) || !failed.isEmpty(); }) && failed.isEmpty();
  }
  bool stepTo(int iteration) {
    while (document.iteration() < iteration) {
      const int next = std::max(0, document.iteration()) + 1;  // the seeds are shown as iteration 0 before
      document.stepForward();
      if (!waitFor([&] { return document.iteration() >= next && isAtRest(document); })) return false;
    }
    return true;
  }
};

//! Runs handlebody-cli; its exit code.
inline int runCli(const QStringList& arguments) {
  QProcess process;
  process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  process.start(QStringLiteral(HANDLEBODY_CLI), arguments);
  process.waitForFinished(120'000);
  return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
}

//! A test of this program in a process of its own, killed as soon as it says that it is ready. While it lives
//! there is nothing to recover. Returns what there is to recover then.
inline QStringList killedAtWork(const TorusFile& torus, const QString& test) {
  QProcess child;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("HANDLEBODY_TEST_DATA"), QStringLiteral("keep"));
  environment.insert(QStringLiteral("HANDLEBODY_TEST_VOLUME"), torus.path);
  child.setProcessEnvironment(environment);
  child.start(QCoreApplication::applicationFilePath(), {test});
  QByteArray said;
  REQUIRE(waitFor([&] { return (said += child.readAllStandardOutput()).contains("ready"); }));
  CHECK(Document::recoverable().isEmpty());
  child.kill();
  child.waitForFinished();
  return Document::recoverable();
}

}  // namespace handlebody::ui
