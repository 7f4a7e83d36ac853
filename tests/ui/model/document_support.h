#pragma once
// A Document, volumes on disk, and waiting with a limit.

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QThread>
#include <QUndoStack>

#include "core/io/formats/volume_io.h"
#include "core/io/meshes/mesh_io.h"
#include "tests/core/evolution/contour_support.h"
#include "tests/support/catch.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! Runs the event loop until `done`, or for `seconds`; what `done` says then.
template <typename Done>
bool waitFor(Done&& done, int seconds = 60) {
  const QDeadlineTimer deadline(std::chrono::seconds{seconds});
  while (!done()) {
    if (deadline.hasExpired()) return false;
    QCoreApplication::processEvents();
    QThread::msleep(1);
  }
  return true;
}

//! Runs the event loop for a while.
inline void waitMilliseconds(int milliseconds) {
  const QDeadlineTimer deadline(milliseconds);
  while (!deadline.hasExpired()) {
    QCoreApplication::processEvents();
    QThread::msleep(1);
  }
}

//! A dark torus in 41³ voxels on disk.
struct TorusFile {
  QTemporaryDir folder;
  QString path;
  Seed seed;

  TorusFile() : path(folder.filePath(QStringLiteral("torus.mha"))) {
    writeVolume(testing::torusVolume(), path.toStdString());
    seed = {testing::kMiddle + Vec3(testing::kTorusR, 0, 0), 3.0};
  }
  QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
};

//! Opens and waits; false if it failed.
inline bool openAndWait(Document& document, const QString& path) {
  bool ok = false, failed = false;
  const auto a = QObject::connect(&document, &Document::opened, [&] { ok = true; });
  const auto b = QObject::connect(&document, &Document::openFailed, [&] { failed = true; });
  document.open(path);
  const bool ended = waitFor([&] { return ok || failed; });
  QObject::disconnect(a);
  QObject::disconnect(b);
  return ended && ok;
}

inline bool isAtRest(const Document& document) {
  return document.state() == GrowthState::paused || document.state() == GrowthState::finished;
}

//! Runs to the end; false if it did not get there.
inline bool runToEnd(Document& document) {
  document.run();
  return waitFor([&] { return document.state() == GrowthState::finished; }, 120);
}

//! Goes to an iteration and waits for it.
inline bool showIteration(Document& document, int iteration) {
  document.goTo(iteration);
  return waitFor([&] { return document.iteration() == iteration; });
}

inline bool isSame(const TriangleSoup& a, const TriangleSoup& b) {
  return a.triangles == b.triangles && a.points == b.points;
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace handlebody::ui
