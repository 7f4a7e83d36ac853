#include "ui/window/open/file_work.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QUndoStack>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "core/io/dicom/dicom_class.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/label_map.h"
#include "ui/model/document.h"
#include "ui/model/error_sentence.h"
#include "ui/model/file_name.h"
#include "ui/model/finding_text.h"
#include "ui/window/export/export_panel.h"
#include "ui/window/open/open_objects_dialog.h"
#include "ui/window/widgets/message_bar.h"

namespace handlebody::ui {

namespace {

constexpr int kMaxRecent = 10;
constexpr int kBeforeProgress = 400;  // ms: what is quicker shows none
const QString kRecent = QStringLiteral("recent");
const QString kFolder = QStringLiteral("folder");

QString volumeFilter() {
  return FileWork::tr(
      "Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm "
      "*.json);;"
      "All files (*)");
}

QString objectFilter() {
  return FileWork::tr(
      "Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl "
      "*.gipl.gz *.dcm);;"
      "All files (*)");
}

// Beside an installed program, or in the source tree that the program was built from.
QString samplePath() {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* folder : {"../share/handlebody/sample_volumes", "../../../sample_volumes"}) {
    const QString path = program.filePath(QLatin1String(folder) + QStringLiteral("/cyst_session.json"));
    if (QFileInfo::exists(path)) return QFileInfo(path).canonicalFilePath();
  }
  return {};
}

// It belongs to the program: to save must not overwrite it.
bool isSample(const QString& path) {
  const QString sample = samplePath();
  return !sample.isEmpty() && QFileInfo(path).canonicalFilePath() == sample;
}

bool isSegmentation(const std::string& path) {
  return isSlicerSegmentationPath(path) || isDicomSegmentationPath(path) || isDicomSegmentationFile(path);
}

// Of a volume that is open or being opened: another layer of a segmentation, say, is no object of it.
bool isPartOfFile(const VolumeSelection& chosen) { return chosen.series || chosen.frame || chosen.spacing; }

}  // namespace

FileWork::FileWork(Document& document, ViewGrid& views, ExportPanel& exports, MessageBar& messages,
                   QWidget* window)
    : QObject(window),
      document_(document),
      views_(views),
      exports_(exports),
      messages_(messages),
      window_(window) {
  connectMessages();
  connectObjects();
  document_.setOpeningWaits(true);
  connect(&document_, &Document::openingWaits, this, &FileWork::replaceOpen);
}

void FileWork::connectMessages() {
  const auto said = [this](const QString& text) { messages_.show(MessageBar::Kind::information, text); };
  const auto failed = [this](const QString& text) { messages_.show(MessageBar::Kind::error, text); };
  connect(&document_, &Document::openFailed, this, &FileWork::sayOpenFailed);
  connect(&document_, &Document::fileNeeded, this, &FileWork::askForFile);
  connect(&document_, &Document::opened, this, [this] {
    if (!remembered_.isEmpty()) remember(remembered_);
  });
  connect(&document_, &Document::journalFailed, this,
          [this](const QString& text) { messages_.show(MessageBar::Kind::warning, text); });
  connect(&document_, &Document::exportFailed, this, [this, failed](const QString& text) {
    failed(text);
    afterWriting(false);
  });
  connect(&document_, &Document::exportRefused, this, [this, failed](const QString& text) {
    failed(text);
    closesWhenWritten_ = false;
  });
  connect(&document_, &Document::saveFailed, this, [this, failed](const QString& text) {
    next_ = nullptr;
    failed(text);
    afterSaving(false);
  });
  connect(&document_, &Document::exporting, this, [this] { ++writing_; });
  connect(&document_, &Document::polished, this, [this](const QString& text) { polished_ = text; });
  connect(&document_, &Document::leftOutOfLabelMap, this, [this](const QString& text) { leftOut_ = text; });
  connect(&document_, &Document::exported, this, [this, said](const QString& path) {
    // The next file has its own.
    const QString polished = std::exchange(polished_, {}), leftOut = std::exchange(leftOut_, {});
    QString written = tr("%1 is written.").arg(path);
    if (!polished.isEmpty()) written += QLatin1Char(' ') + polished;
    if (leftOut.isEmpty())
      said(written);
    else
      messages_.show(MessageBar::Kind::warning, written + QLatin1Char(' ') + leftOut);
    afterWriting(leftOut.isEmpty());  // a warning is read before the window closes
  });
  connect(&document_, &Document::exportCancelled, this, [this] { afterWriting(true); });
  connect(&document_, &Document::sessionSaved, this, [this, said](const QString& path) {
    const QStringList anew = document_.notReplayed();
    const QString saved =
        tr("The session is saved as %1.").arg(path) +
        (anew.isEmpty() ? QString()
                        : QLatin1Char(' ') + tr("A replay grows anew: %1.").arg(anew.join(tr(", "))));
    const QString lost = document_.leftOut();
    lost.isEmpty() ? said(saved) : messages_.show(MessageBar::Kind::warning, saved + QLatin1Char(' ') + lost);
    remember(path);
    afterSaving(true);
  });
}

void FileWork::afterSaving(bool isWell) {
  saving_ = std::max(0, saving_ - 1);
  if (const auto next = std::exchange(next_, nullptr)) next();
  closeIfWritten(isWell);
  replaceOpenSoon();
}

QString FileWork::lastFolder() { return QSettings().value(kFolder).toString(); }

QStringList FileWork::recent() const {
  QStringList there;
  const auto paths = QSettings().value(kRecent).toStringList();
  for (const QString& path : paths)
    if (QFileInfo::exists(path)) there << path;
  return there;
}

void FileWork::remember(const QString& path) {
  QSettings settings;
  QStringList paths = settings.value(kRecent).toStringList();
  const QString absolute = QFileInfo(path).absoluteFilePath();
  paths.removeAll(absolute);
  paths.prepend(absolute);
  settings.setValue(kRecent, paths.mid(0, kMaxRecent));
  settings.setValue(kFolder, QFileInfo(absolute).absolutePath());
  Q_EMIT recentChanged();
}

void FileWork::chooseFile() {
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Open a volume or a session"), lastFolder(), volumeFilter(), nullptr,
      QFileDialog::HideNameFilterDetails);  // the endings would not fit
  if (!path.isEmpty()) open(path);
}

void FileWork::chooseFolder() {
  const QString path =
      QFileDialog::getExistingDirectory(window_, tr("Open a folder with a DICOM series"), lastFolder());
  if (!path.isEmpty()) open(path);
}

void FileWork::chooseObjects() {
  const QString path =
      QFileDialog::getOpenFileName(window_, tr("Open a mesh or a label map"), lastFolder(), objectFilter(),
                                   nullptr, QFileDialog::HideNameFilterDetails);
  if (!path.isEmpty()) openObjects(path);
}

void FileWork::openObjects(const QString& path) {
  auto* dialog = new OpenObjectsDialog(path, window_);
  connect(dialog, &OpenObjectsDialog::chosen, &document_, &Document::openObjects);
  connect(dialog, &OpenObjectsDialog::failed, this,
          [this](const QString& text) { messages_.show(MessageBar::Kind::error, text); });
  connect(&document_, &Document::opened, dialog, &QDialog::reject);  // they were meant for what was open
  dialog->open();
}

//! How long it takes is not known.
void FileWork::connectObjects() {
  auto* progress = new QProgressDialog(window_);
  progress->setRange(0, 0);
  progress->setAutoClose(false);
  progress->setMinimumDuration(kBeforeProgress);
  progress->setWindowModality(Qt::NonModal);
  progress->setWindowTitle(tr("Open objects"));
  progress->reset();
  connect(progress, &QProgressDialog::canceled, &document_, &Document::cancelOpeningObjects);
  connect(&document_, &Document::openingObjects, progress, [progress](const QString& path) {
    progress->setLabelText(tr("Making surfaces of %1…").arg(QFileInfo(path).fileName()));
    progress->setValue(0);
  });
  const auto end = [this, progress](MessageBar::Kind kind, const QString& text) {
    progress->reset();
    progress->hide();  // which reset leaves to whoever does not close by itself
    if (!text.isEmpty()) messages_.show(kind, text);
  };
  connect(&document_, &Document::objectsOpened, progress,
          [end](const QString& path, const QStringList& names, qint64 shared) {
            const QString open =
                tr("%1 is open as: %2.").arg(QFileInfo(path).fileName(), names.join(tr(", ")));
            if (shared == 0) return end(MessageBar::Kind::information, open);
            end(MessageBar::Kind::warning,
                open + QLatin1Char(' ') +
                    tr("Segments overlap: what several of them hold is left to the smallest (voxels: %1). "
                       "Step 4, Grow, tells it of each.")
                        .arg(QLocale().toString(shared)));
          });
  connect(&document_, &Document::openingObjectsFailed, progress,
          [end](const QString& text) { end(MessageBar::Kind::error, text); });
  connect(&document_, &Document::openingObjectsCancelled, progress, [end] { end({}, {}); });
}

void FileWork::open(const QString& path, const VolumeSelection& selection) {
  const std::string name = fileName(path);
  const bool isMesh = isMeshInputPath(name);
  if (isMesh && !document_.hasVolume())
    return messages_.show(MessageBar::Kind::error,
                          tr("%1 is a surface: open the volume first that it lies in.").arg(path));
  if (isMesh || (document_.hasVolume() && !isPartOfFile(selection) && isSegmentation(name)))
    return openObjects(path);
  whenSaved([this, path, selection] {
    begin(path, selection);
    remembered_ = path;
  });
}

void FileWork::begin(const QString& path, const VolumeSelection& selection) {
  // When only its series is chosen the session is still told where its files are.
  if (path != asked_ || !selection.series) given_.clear();
  asked_ = path;
  askedSelection_ = selection;
  remembered_.clear();
  document_.open(path, selection, given_);
}

//! The offer waits: until it is taken the work that is open goes on.
void FileWork::askForFile(const QString& session, FindingKind missing, const QString& refused,
                          const QStringList& taken) {
  asked_ = session;
  given_ = taken;
  std::vector<MessageBar::Answer> answers{
      {tr("Choose the file…"), [this, session, missing] { chooseNeeded(session, missing, false); }}};
  if (missing == FindingKind::sessionWithoutVolume)
    answers.push_back(
        {tr("Choose the folder…"), [this, session, missing] { chooseNeeded(session, missing, true); }});
  messages_.show(MessageBar::Kind::warning, refused.isEmpty() ? findingSentence(missing) : refused, answers);
}

void FileWork::chooseNeeded(const QString& session, FindingKind missing, bool isFolder) {
  if (session != asked_) return;  // another one is being opened by now
  const QString folder = lastFolder(), title = tr("Choose what the session needs");
  const QString path = isFolder ? QFileDialog::getExistingDirectory(window_, title, folder)
                                : QFileDialog::getOpenFileName(window_, title, folder);
  if (path.isEmpty()) return askForFile(session, missing, {}, given_);
  whenSaved([this, path] { give(path); });
}

void FileWork::give(const QString& path) {
  given_ << path;
  document_.open(asked_, askedSelection_, given_);
}

void FileWork::sayOpenFailed(const QString& sentence, bool needsSpacing) {
  std::vector<MessageBar::Answer> answers;
  if (needsSpacing)
    answers.push_back({tr("Enter the spacing"), [this, path = asked_, selection = askedSelection_] {
                         Q_EMIT spacingNeeded(path, selection);
                       }});
  messages_.show(MessageBar::Kind::error, sentence, answers);
}

void FileWork::openSample() {
  const QString path = samplePath();
  if (path.isEmpty())
    messages_.show(MessageBar::Kind::error, tr("The sample is not installed with this program."));
  else
    whenSaved([this, path] { begin(path, {}); });  // its folder is not where the user keeps work
}

//! Who worked on while it was read is asked about that: nobody has been when it was to be opened. Questions
//! that are asked then, and a session that is written, are about the work that is open; that stays until
//! then.
void FileWork::replaceOpen() {
  if (asking_ > 0 || saving_ > 0 || !document_.isOpeningWaiting()) return;
  if (!document_.isChangedSinceOpen()) return document_.finishOpening();
  whenSaved([this] { document_.finishOpening(); }, [this] { document_.cancelOpening(); });
}

//! When whoever calls is done.
void FileWork::replaceOpenSoon() {
  QMetaObject::invokeMethod(this, &FileWork::replaceOpen, Qt::QueuedConnection);
}

void FileWork::whenSaved(std::function<void()> next, const std::function<void()>& otherwise) {
  if (!document_.hasVolume() || !document_.isModified()) return next();
  const Asking asking(*this);
  QMessageBox question(QMessageBox::Question, tr("Unsaved work"), tr("Save the seeds and parameters first?"),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question.setInformativeText(
      tr("They are kept in a session, from which the same surface can be grown again."));
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      // What is changed until it is written is asked about, too; how far the growth has got by then is not.
      next_ = [this, next = std::move(next), otherwise] {
        document_.undoStack()->isClean() ? next() : whenSaved(next, otherwise);
      };
      return save();
    case QMessageBox::Discard:
      return next();
    default:
      if (otherwise) otherwise();
  }
}

bool FileWork::isAgreed(const QString& title, const QString& question) {
  const Asking asking(*this);
  return QMessageBox::question(window_, title, question) == QMessageBox::Yes;
}

void FileWork::closeWindow() { QMetaObject::invokeMethod(window_, &QWidget::close, Qt::QueuedConnection); }

void FileWork::afterWriting(bool isWell) {
  writing_ = std::max(0, writing_ - 1);
  closeIfWritten(isWell);
}

//! The window stays where a file could not be written: else nobody would read why.
void FileWork::closeIfWritten(bool isWell) {
  if (!isWell) closesWhenWritten_ = false;
  if (writing_ > 0 || saving_ > 0 || closing_) return;
  if (std::exchange(closesWhenWritten_, false)) closeWindow();
}

//! What is written ends first, well or not.
void FileWork::closeWhenWritten() {
  closesWhenWritten_ = true;
  messages_.show(MessageBar::Kind::information,
                 tr("A file is being written. The window closes when it is done."),
                 {{tr("Stay open"), [this] { closesWhenWritten_ = false; }}});
}

// The answer ends in another close(), which asks no more. A later one does.
bool FileWork::mayClose() {
  const bool isAnswered = std::exchange(closing_, false);
  if (writing_ > 0 || saving_ > 0) {
    closeWhenWritten();
    return false;
  }
  if (isAnswered || !document_.hasVolume() || !document_.isModified()) return true;
  whenSaved([this] {
    closing_ = true;
    closeWindow();
  });
  return false;
}

void FileWork::save() {
  const QString path = document_.sessionPath();
  if (path.isEmpty() || isSample(path)) return saveAs();
  // While it is being written here it is not known yet what that leaves there.
  if (saving_ == 0 && document_.isSessionChangedElsewhere()) return saveOverChanged(path);
  saveSession(path);
}

//! As another window or program does that has the same session.
void FileWork::saveOverChanged(const QString& path) {
  const Asking asking(*this);
  QMessageBox question(
      QMessageBox::Question, tr("Save the session"),
      tr("%1 was changed elsewhere since it was opened or saved here. Replace what is there?")
          .arg(QFileInfo(path).fileName()),
      QMessageBox::Cancel, window_);
  const QAbstractButton* overwrite = question.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  auto* elsewhere = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
  question.setDefaultButton(elsewhere);
  question.exec();
  if (question.clickedButton() == overwrite) return saveSession(path);
  if (question.clickedButton() == elsewhere) return saveAs();
  next_ = nullptr;
}

void FileWork::saveSession(const QString& path) {
  Q_EMIT aboutToSave();
  ++saving_;  // until it is told how that ended, which may be at once
  document_.saveSession(path);
}

void FileWork::saveAs() {
  const QString path = askForName({tr("Save the session"),
                                   suggestedBase() + QStringLiteral("_session"),
                                   {QStringLiteral(".json")},
                                   tr("Sessions (*.json)")});
  if (path.isEmpty()) {
    next_ = nullptr;
    return;
  }
  saveSession(path);
}

void FileWork::offerRecovery() {
  const QStringList journals = Document::recoverable();
  if (journals.isEmpty()) return;
  const QString journal = journals.front();
  messages_.ask(MessageBar::Kind::warning,
                tr("The program ended unexpectedly last time. Its seeds and parameters were kept."),
                {{tr("Restore"), [this, journal] { recover(journal); }},
                 {tr("Discard"), [journal] { Document::discardRecoverable(journal); }}});
}

//! A journal whose reading is cancelled, fails or gives way to another file stays, and is offered again.
void FileWork::recover(const QString& journal) {
  whenSaved([this, journal] { begin(journal, {}); });
}

}  // namespace handlebody::ui
