#pragma once
// What tells that somebody else has written a file meanwhile.

#include <QDateTime>
#include <QFileInfo>
#include <QString>

namespace handlebody::ui {

struct FileStamp {
  qint64 size = -1;      //!< bytes; -1: there is no file
  QDateTime modified{};  //!< to the millisecond
  bool isThere() const { return size >= 0; }
  bool operator==(const FileStamp&) const = default;
};

inline FileStamp stampOf(const QString& path) {
  const QFileInfo file(path);
  return file.isFile() ? FileStamp{file.size(), file.lastModified()} : FileStamp{};
}

}  // namespace handlebody::ui
