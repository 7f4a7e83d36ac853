#pragma once
// A few frames of the beating phantom, made by the program itself, with a session in which it is clicked
// into.

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include "tests/ui/window/window_support.h"

namespace handlebody::test {

struct BeatingSample {
  static constexpr int kFrames = 5;
  QTemporaryDir folder;
  QString volume = folder.filePath("heart.nii.gz"), session = folder.filePath("session.json");
  Vec3 seed{0, 0, 0};

  //! False: it could not be made.
  bool make() {
    QProcess process;
    process.start(QStringLiteral(HANDLEBODY_CLI), {"phantom", "beating", "-o", volume, "--frames",
                                                   QString::number(kFrames), "--spacing", "3,3,3"});
    if (!process.waitForFinished(kPatience) || process.exitCode() != 0) return false;
    const QJsonObject said = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
    const QJsonArray centre = said["seed"].toObject()["centre"].toArray();
    if (centre.size() != 3) return false;
    seed = {centre[0].toDouble(), centre[1].toDouble(), centre[2].toDouble()};
    const QJsonObject click{{"centre", centre}};
    const QJsonObject all{{"version", "0.1.0"},
                          {"input", QJsonObject{{"path", "heart.nii.gz"}, {"sha256", QJsonValue::Null}}},
                          {"requested", QJsonObject{{"seeds", QJsonArray{click}}}}};
    QFile file(session);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(all).toJson()) > 0;
  }
};

}  // namespace handlebody::test
