#pragma once
// Seeds and parameters on disk while one works, so that a crash loses nothing. A journal is a session file; a
// lock beside it tells that the program that writes it still lives.

#include <QLockFile>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "core/io/report/session.h"
#include "ui/model/background.h"

namespace handlebody::ui {

class Journal {
 public:
  //! `failed`: called on a worker thread with a sentence when it cannot be written; again only after it could
  //! be in between.
  explicit Journal(std::function<void(const QString&)> failed);
  //! A clean close: the journal goes.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  //! Other work is open, and of what was open before nothing is left to recover. `opened`: what it came from.
  //! If that is a journal whose program has ended it goes, but not before this one is written or closed.
  void startWith(const QString& opened);
  //! Writes the session, of one object or of several, on a worker thread; of those that wait, only the
  //! newest.
  void write(const std::vector<Session>& objects);
  //! Nothing is left to recover.
  void clear();

  //! True for a file in the journals' folder.
  static bool isJournal(const QString& path);
  //! Journals whose program ended without a clean close, newest first.
  static QStringList recoverable();
  static void discard(const QString& path);

 private:
  void writeNow(const std::vector<Session>& objects, const QString& restored);

  std::function<void(const QString&)> failed_;
  QString path_;
  QString restored_;  // the journal that the open work came from; empty: none
  std::unique_ptr<QLockFile> lock_;
  bool fails_ = false;     // of the worker thread
  Background background_;  // last: its job uses the path
};

}  // namespace handlebody::ui
