// What is written under names that are asked for: results, frames, reports, pictures, tables.

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageWriter>
#include <QMessageBox>
#include <QSaveFile>
#include <algorithm>

#include "core/io/atomic_file.h"
#include "core/io/report/frame_files.h"
#include "ui/model/document.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"
#include "ui/model/time_series.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/open/file_work.h"
#include "ui/window/views/view_grid.h"
#include "ui/window/widgets/in_background.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::ui {

namespace {

// A file name without ".nii.gz" and its like.
QString baseName(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  const auto dot = name.indexOf(QLatin1Char('.'), 1);
  return dot < 0 ? name : name.left(dot);
}

}  // namespace

QString FileWork::suggestedBase(bool mayTell) const {
  const QString folder = lastFolder().isEmpty() ? QDir::homePath() : lastFolder();
  const bool isNamed = mayTell && document_.hasVolume() && !exports_.isAnonymous();
  QString name = isNamed ? baseName(document_.path()) : QString();
  name.remove(QLatin1Char('"'));  // which separate names in the dialog
  return QDir(folder).filePath(name.isEmpty() ? QStringLiteral("handlebody") : name);
}

//! The dialog would ask about the name as it is typed, without its ending, and of one file only.
QString FileWork::askForName(const NameQuestion& question) {
  const Asking asking(*this);
  QStringList filters;
  for (const QString& ending : question.endings) filters << QStringLiteral("*%1 (*%1)").arg(ending);
  const QString filter = question.filter.isEmpty() ? filters.join(QStringLiteral(";;")) : question.filter;
  QString path = question.suggestion + question.endings.front(), chosen = filters.front();
  for (;;) {
    path = QFileDialog::getSaveFileName(window_, question.title, path, filter, &chosen,
                                        QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty()) return path;
    const auto isEnding = [&](const QString& e) { return path.endsWith(e, Qt::CaseInsensitive); };
    if (std::none_of(question.endings.begin(), question.endings.end(), isEnding))
      path += question.endings[std::max<qsizetype>(0, filters.indexOf(chosen))];
    if (mayReplace(question.title, question.files ? question.files(path) : QStringList{path})) return path;
  }
}

bool FileWork::mayReplace(const QString& title, const QStringList& files) {
  constexpr qsizetype kNamed = 8;  // a message of a thousand frames would not fit
  QStringList there;
  for (const QString& file : files)
    if (QFileInfo::exists(file)) there << QFileInfo(file).fileName();
  if (there.isEmpty()) return true;
  if (const qsizetype more = there.size() - kNamed; more > 0)
    there = there.mid(0, kNamed) << tr("%1 more").arg(more);
  return QMessageBox::question(window_, title,
                               tr("There already: %1. Replace what is there?").arg(there.join(tr(", ")))) ==
         QMessageBox::Yes;
}

//! By the step Export, if `path` is chosen.
QStringList FileWork::exportedFiles(const QString& path) const {
  if (exports_.which() != ExportPanel::Objects::each) return {path};
  return document_.objectPaths(path, exports_.extension(), exports_.isAnonymous());
}

void FileWork::exportResult() {
  const QString extension = exports_.extension();
  if (const QString fault = document_.exportFault(extension); !fault.isEmpty())
    return messages_.show(MessageBar::Kind::error, fault);
  const QString path = askForName({tr("Export the result"),
                                   suggestedBase() + QStringLiteral("_surface"),
                                   {extension},
                                   QStringLiteral("*%1").arg(extension),
                                   [this](const QString& chosen) { return exportedFiles(chosen); }});
  if (path.isEmpty()) return;
  switch (exports_.which()) {
    case ExportPanel::Objects::together:
      return document_.exportObjects(path, exports_.space(), exports_.content());
    case ExportPanel::Objects::each:
      return document_.exportEachObject(path, extension, exports_.space(), exports_.content());
    case ExportPanel::Objects::active:
      return document_.exportResult(path, exports_.space(), exports_.content());
  }
}

void FileWork::exportFrames(bool asLabels) {
  const QStringList endings = asLabels ? QStringList{QStringLiteral(".nii.gz"), QStringLiteral(".nrrd")}
                                       : QStringList{QStringLiteral(".vtp"), QStringLiteral(".stl"),
                                                     QStringLiteral(".ply"), QStringLiteral(".obj")};
  NameQuestion question{asLabels ? tr("Export a 4D label map") : tr("Export the meshes of all frames"),
                        suggestedBase() + (asLabels ? QStringLiteral("_labels") : QStringLiteral("_frame")),
                        endings};
  if (!asLabels) question.files = [this](const QString& chosen) { return frameFiles(chosen); };
  const QString path = askForName(question);
  if (!path.isEmpty()) document_.exportFrames(path, exports_.space());
}

//! The meshes of all frames that there may be, if `path` is chosen.
QStringList FileWork::frameFiles(const QString& path) const {
  std::vector<int> frames{document_.time().grownFrame()};
  for (const auto& [frame, carried] : document_.time().carried()) frames.push_back(frame);
  QStringList files;
  for (const std::string& file : frameMeshPaths(fileName(path), frames))
    files << QFile::decodeName(file.c_str());
  return files;
}

void FileWork::exportReport() {
  const QString path = askForName({tr("Export the report"),
                                   suggestedBase() + QStringLiteral("_report"),
                                   {QStringLiteral(".json")},
                                   QStringLiteral("*.json")});
  if (!path.isEmpty()) document_.exportReport(path, exports_.isAnonymous());
}

void FileWork::exportAnonymousSession() {
  const QString path = askForName({tr("Export an anonymous session"),
                                   suggestedBase(false) + QStringLiteral("_session"),
                                   {QStringLiteral(".json")},
                                   tr("Sessions (*.json)")});
  if (!path.isEmpty()) document_.exportAnonymousSession(path);
}

bool FileWork::isRefused(const QString& path) {
  const QString fault = document_.outputFault(path);
  if (!fault.isEmpty()) messages_.show(MessageBar::Kind::error, fault);
  return !fault.isEmpty();
}

void FileWork::exportPicture() {
  const QImage picture = views_.picture(exports_.pictureOf());  // before a dialog covers the views
  const QString path = askForName(
      {tr("Export a picture"), suggestedBase(), {QStringLiteral(".png")}, QStringLiteral("*.png")});
  if (path.isEmpty() || isRefused(path)) return;
  QSaveFile file(path);  // whole or not at all
  QImageWriter writer(&file, "png");
  if (file.open(QIODevice::WriteOnly) && writer.write(picture) && file.commit())
    messages_.show(MessageBar::Kind::information, tr("%1 is written.").arg(path));
  else
    messages_.show(MessageBar::Kind::error, tr("%1 cannot be written: %2.").arg(path, file.errorString()));
}

void FileWork::saveText(const QString& title, const QString& what, const QString& extension,
                        const std::string& text) {
  const QString path = askForName(
      {title, suggestedBase() + QLatin1Char('_') + what, {extension}, QStringLiteral("*%1").arg(extension)});
  if (path.isEmpty() || isRefused(path)) return;
  const QString fault = whyNot([&] { writeTextAtomically(fileName(path), text); });
  if (fault.isEmpty())
    messages_.show(MessageBar::Kind::information, tr("%1 is written.").arg(path));
  else
    messages_.show(MessageBar::Kind::error, fault);
}

void FileWork::saveFile(const QString& title, const QString& what, const QString& extension,
                        const FileWriter& write) {
  const QString path = askForName(
      {title, suggestedBase() + QLatin1Char('_') + what, {extension}, QStringLiteral("*%1").arg(extension)});
  if (path.isEmpty() || isRefused(path)) return;
  ++writing_;
  inBackground(
      this, [write, name = fileName(path)] { return whyNot([&] { write(name); }); },
      [this, path](const QString& error) {
        if (error.isEmpty())
          messages_.show(MessageBar::Kind::information, tr("%1 is written.").arg(path));
        else
          messages_.show(MessageBar::Kind::error, error);
        afterWriting(error.isEmpty());
      });
}

}  // namespace handlebody::ui
