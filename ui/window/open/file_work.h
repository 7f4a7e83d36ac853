#pragma once
// Files: open, save, export, recent ones, and the questions about unsaved work.

#include <QObject>
#include <QStringList>
#include <functional>
#include <string>

#include "core/finding.h"
#include "core/io/formats/volume_io.h"
#include "ui/window/widgets/file_writer.h"

class QWidget;

namespace handlebody::ui {

class Document;
class ExportPanel;
class MessageBar;
class ViewGrid;

class FileWork : public QObject {
  Q_OBJECT

 public:
  FileWork(Document& document, ViewGrid& views, ExportPanel& exports, MessageBar& messages, QWidget* window);

  void chooseFile();
  void chooseFolder();
  //! Of a mesh or label map that is asked for.
  void chooseObjects();
  //! Asks what is to become of them, and which of a label map, without waiting for the answer.
  void openObjects(const QString& path);
  //! Asks about unsaved work first. What can only be the surface of something is opened as an object of the
  //! volume that is open.
  void open(const QString& path, const VolumeSelection& selection = {});
  //! The file that the anonymous session which is being opened was asked for last.
  void give(const QString& path);
  //! The ultrasound sample with its seed. To save it asks for a name: the sample itself stays as it is.
  void openSample();
  void save();
  void saveAs();
  void exportResult();
  void exportReport();
  void exportAnonymousSession();
  void exportPicture();
  //! Of all frames that the surface was carried through: numbered meshes, or a 4D label map.
  void exportFrames(bool asLabels);
  //! Asks for a name that begins as the volume's and ends in `what`, and writes the text there.
  void saveText(const QString& title, const QString& what, const QString& extension, const std::string& text);
  //! The same of a file that `write` makes on a worker thread. It may throw: why is told. The window does not
  //! close before that has ended.
  void saveFile(const QString& title, const QString& what, const QString& extension, const FileWriter& write);
  //! True if the window may close now. Else a file is being written, after which it closes, or it asks about
  //! unsaved work, and closes the window when the answer is carried out.
  bool mayClose();
  //! True: the user says yes. What is read meanwhile waits: the question is about the work that is open.
  bool isAgreed(const QString& title, const QString& question);
  //! Offers work that a crash left behind.
  void offerRecovery();

  QStringList recent() const;

 Q_SIGNALS:
  void recentChanged();
  //! A file can only be opened if the user says how large its voxels are.
  void spacingNeeded(const QString& path, const handlebody::VolumeSelection& selection);
  //! Before a session is written: whoever has something to keep in it says so now.
  void aboutToSave();

 private:
  void remember(const QString& path);
  void begin(const QString& path, const VolumeSelection& selection);
  //! Runs `next` at once, after saving, or not at all, as the user answers; `otherwise` if not at all.
  void whenSaved(std::function<void()> next, const std::function<void()>& otherwise = {});
  void saveSession(const QString& path);
  void saveOverChanged(const QString& path);
  class Asking;
  void replaceOpen();
  void replaceOpenSoon();
  void afterSaving(bool isWell);
  void closeWindow();
  void closeWhenWritten();
  void afterWriting(bool isWell);
  void closeIfWritten(bool isWell);
  void recover(const QString& journal);
  //! What is written under a name that was chosen, e.g. a file for each object.
  using FilesOf = std::function<QStringList(const QString& path)>;
  //! What a user is asked when a name for a new file is needed.
  struct NameQuestion {
    QString title;
    QString suggestion;     //!< without its ending
    QStringList endings{};  //!< the file has one of them; the first is suggested
    QString filter{};       //!< of the dialog; empty: one for each ending
    FilesOf files{};        //!< none: the file that is named
  };
  //! Asks until it is a name of which nothing is lost, or what is lost may be; empty: no longer wanted.
  QString askForName(const NameQuestion& question);
  //! True, and says so, if the open work is read from it: of files that the document does not write itself.
  bool isRefused(const QString& path);
  bool mayReplace(const QString& title, const QStringList& files);
  QStringList exportedFiles(const QString& path) const;
  QStringList frameFiles(const QString& path) const;
  //! `mayTell`: it may tell the volume's name, if the step Export does not say otherwise.
  QString suggestedBase(bool mayTell = true) const;
  //! Of what was opened or saved last; empty: none.
  static QString lastFolder();
  void connectMessages();
  void connectObjects();
  void sayOpenFailed(const QString& sentence, bool needsSpacing);
  void askForFile(const QString& session, FindingKind missing, const QString& refused,
                  const QStringList& taken);
  void chooseNeeded(const QString& session, FindingKind missing, bool isFolder);

  Document& document_;
  ViewGrid& views_;
  ExportPanel& exports_;
  MessageBar& messages_;
  QWidget* window_;
  std::function<void()> next_;      //!< what waits for the session to be saved
  QString asked_;                   //!< what was to be opened last
  VolumeSelection askedSelection_;  //!< and how
  QStringList given_;               //!< the files of that session, which does not name them
  QString polished_;                //!< what polishing did to the file that is being written
  QString leftOut_;                 //!< what it leaves out, as a label map
  QString remembered_;              //!< stands among the recent ones once it is open; empty: does not
  int writing_ = 0;                 //!< files, or sets of them, that are not there yet
  int saving_ = 0;                  //!< sessions that are not
  int asking_ = 0;                  //!< questions about the work that is open
  bool closesWhenWritten_ = false;
  bool closing_ = false;  //!< the next close() needs no answer any more
};

//! While one lives the user is asked about the work that is open, which stays until he has answered.
class FileWork::Asking {
 public:
  explicit Asking(FileWork& work) : work_(work) { ++work_.asking_; }
  ~Asking() {
    --work_.asking_;
    work_.replaceOpenSoon();
  }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  FileWork& work_;
};

}  // namespace handlebody::ui
