#pragma once
// Seeds and parameters on disk while one works, so that a crash loses nothing. A journal is a session file; a
// lock beside it tells that the program that writes it still lives.

#include <QLockFile>
#include <QString>
#include <QStringList>
#include <memory>

#include "core/io/report/session.h"
#include "ui/model/background.h"

namespace handlebody::ui {

class Journal {
 public:
  Journal();
  //! A clean close: the journal goes.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

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
  QString path_;
  std::unique_ptr<QLockFile> lock_;
  Background background_;  // last: its job uses the path
};

}  // namespace handlebody::ui
