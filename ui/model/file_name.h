#pragma once
// The path that the engine's readers and writers take.

#include <QFile>
#include <QString>
#include <string>

namespace handlebody::ui {

//! In the encoding of the file system.
inline std::string fileName(const QString& path) { return QFile::encodeName(path).toStdString(); }

}  // namespace handlebody::ui
