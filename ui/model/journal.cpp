#include "ui/model/journal.h"
#include "ui/model/file_name.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <atomic>
#include <cstdio>

namespace handlebody::ui {

namespace {

QDir folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QLatin1String("/journal"));
}

QString lockOf(const QString& path) { return path + QLatin1String(".lock"); }

// A journal that cannot be written must not stop the work; it is said once.
void write(const std::vector<Session>& objects, const std::string& path) try {
  writeSessions(objects, path);
} catch (const std::exception& error) {
  static std::atomic<bool> said{false};  // as stderr is one for all journals
  if (!said.exchange(true)) std::fprintf(stderr, "handlebody: no journal is kept: %s\n", error.what());
}

}  // namespace

Journal::Journal() {
  static std::atomic<int> count{0};  // of the process: two journals of one second must not share a file
  const QDir dir = folder();
  dir.mkpath(QLatin1String("."));
  const QString stamp = QDateTime::currentDateTimeUtc().toString(QLatin1String("yyyyMMdd-HHmmss"));
  const qint64 process = QCoreApplication::applicationPid();
  path_ = dir.filePath(QStringLiteral("%1-%2-%3.json").arg(stamp).arg(process).arg(count++));
  lock_ = std::make_unique<QLockFile>(lockOf(path_));
  lock_->setStaleLockTime(0);  // only the death of the process ends it
  lock_->tryLock(0);
}

Journal::~Journal() {
  background_.postInstead([path = path_] { QFile::remove(path); });
  background_.finish();
}

void Journal::write(const std::vector<Session>& objects) {
  background_.postInstead([objects, path = fileName(path_)] { ui::write(objects, path); });
}

void Journal::clear() {
  background_.postInstead([path = path_] { QFile::remove(path); });
}

bool Journal::isJournal(const QString& path) {
  return QFileInfo(path).absoluteDir().canonicalPath() == folder().canonicalPath();
}

QStringList Journal::recoverable() {
  QStringList orphans;
  const QDir dir = folder();
  for (const QFileInfo& file : dir.entryInfoList({QLatin1String("*.json")}, QDir::Files, QDir::Time)) {
    QLockFile lock(lockOf(file.absoluteFilePath()));
    lock.setStaleLockTime(0);
    if (lock.tryLock(0)) orphans.append(file.absoluteFilePath());  // let go again at once
  }
  return orphans;
}

void Journal::discard(const QString& path) {
  if (!isJournal(path)) return;
  QFile::remove(path);
  QFile::remove(lockOf(path));
}

}  // namespace handlebody::ui
