#include "ui/model/journal.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <atomic>
#include <utility>

#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"

namespace handlebody::ui {

namespace {

QDir folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QLatin1String("/journal"));
}

QString lockOf(const QString& path) { return path + QLatin1String(".lock"); }

void removeWithLock(const QString& path) {
  QFile::remove(path);
  QFile::remove(lockOf(path));
}

bool isOrphan(const QString& path) {
  QLockFile lock(lockOf(path));
  lock.setStaleLockTime(0);
  return lock.tryLock(0);  // let go again at once
}

}  // namespace

Journal::Journal(std::function<void(const QString&)> failed) : failed_(std::move(failed)) {
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
  if (!restored_.isEmpty()) discard(restored_);
}

void Journal::startWith(const QString& opened) {
  clear();
  const QString before = std::exchange(restored_, isJournal(opened) && isOrphan(opened) ? opened : QString());
  if (!before.isEmpty() && before != restored_) discard(before);
}

void Journal::write(const std::vector<Session>& objects) {
  background_.postInstead([this, objects, restored = restored_] { writeNow(objects, restored); });
}

//! On the worker thread. A journal that cannot be written must not stop the work.
void Journal::writeNow(const std::vector<Session>& objects, const QString& restored) {
  const QString why = whyNot([&] { writeSessions(objects, fileName(path_)); });
  if (!why.isEmpty() && !fails_) failed_(why);
  fails_ = !why.isEmpty();
  if (!fails_ && !restored.isEmpty()) removeWithLock(restored);
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
  for (const QFileInfo& file : dir.entryInfoList({QLatin1String("*.json")}, QDir::Files, QDir::Time))
    if (isOrphan(file.absoluteFilePath())) orphans.append(file.absoluteFilePath());
  return orphans;
}

void Journal::discard(const QString& path) {
  if (isJournal(path)) removeWithLock(path);
}

}  // namespace handlebody::ui
