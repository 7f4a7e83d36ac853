#pragma once
// The parts of a Document and how they are joined. Only for document*.cpp.

#include <QUndoStack>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/io/report/report.h"
#include "ui/model/background.h"
#include "ui/model/corrected_frames.h"
#include "ui/model/document.h"
#include "ui/model/file_stamp.h"
#include "ui/model/jobs_under_way.h"
#include "ui/model/journal.h"
#include "ui/model/measurements.h"
#include "ui/model/newest_job.h"
#include "ui/model/object_set.h"
#include "ui/model/opening.h"
#include "ui/model/time_series.h"
#include "ui/model/undo_commands.h"
#include "ui/model/written_meshes.h"

namespace handlebody::ui {

struct OpenedObject;

//! What is told of an object but what takes time.
struct PendingReport {
  RunReport report;
  WrittenObject object;
};

//! On the files' thread: the hash is there, or worked out now. Throws InputError.
void complete(Session& session, std::string& hash);

//! How any object is grown, one that is added later, too.
struct GrowthChoices {
  int stepsPerFrame = 1;
  bool pausesAtLeaks = false;
  void applyTo(SurfaceGrowth& growth) const {
    growth.setStepsPerFrame(stepsPerFrame);
    growth.setPausesAtLeaks(pausesAtLeaks);
  }
};

//! What was read, and has not taken the place of what is open yet.
struct ReadWork {
  QString path;
  OpenedWork work;
};

//! What a session that is being written holds.
struct WrittenState {
  FileStamp stamp{};  // of its file, once it is there
  int edit = 0;
  std::vector<std::pair<std::weak_ptr<ObjectWork>, int>> iterations{};  // the shown one of each object
  // Of a frame, that was under way; none: none was.
  std::optional<std::weak_ptr<const ObjectWork>> correction{};
};

//! How files are written; a session keeps it.
struct OutputChoices {
  bool polishes = true;
  CoordinateSpace space = CoordinateSpace::lps;
  bool operator==(const OutputChoices&) const = default;
};

class Document::Private : public ObjectHost {
 public:
  using Wanted = ObjectWork::Wanted;

  explicit Private(Document& document);
  ~Private() override;

  // --- what the objects ask and tell ---
  const Volume* openVolume() const override { return work ? &work->volume : nullptr; }
  std::vector<FinishedWall> wallsFor(const ObjectWork& object) const override;
  bool mustWait(const ObjectWork& object) const override;
  void changed(const ObjectWork& object, Part part) override;
  void worthKeeping(const ObjectWork& object) override;
  void traced(const ObjectWork& object, int index, const EventTrace& trace) override;
  void leaked(const ObjectWork& object, int index) override;
  void asked(const ObjectWork& object) override;
  void edited(const ObjectWork& object) override;
  void editRefused(ObjectWork& object, const MeshEdit& edit, const QString& why) override;

  // --- opening ---
  void open(const OpeningRequest& asked);
  void finishOpening(int number, const QString& path, OpeningResult result);
  void dropOpening();
  void adopt(const QString& path, OpenedWork opened);
  void adoptObjects(const QString& path, const std::vector<Session>& sessions);
  void hashInBackground();
  void stopHashing();

  // --- objects ---
  ObjectWork& active() const { return *objects.active(); }
  //! Grown as the others are; not among them.
  std::shared_ptr<ObjectWork> newObject();
  void activate(const std::shared_ptr<ObjectWork>& object);
  void tellAll();
  //! Why no object can be added or changed in the list now, as a sentence; empty: it can.
  QString listFault() const;
  //! Why no further object can be added now, as a sentence; empty: it can.
  QString addFault() const;
  void pushList(const QString& text, ObjectList after, int gesture = -1);
  void applyList(const ObjectList& after);
  void pokeAfter(const ObjectWork& object);
  void addOpened(const ObjectsToOpen& asked, const std::vector<OpenedObject>& opened);
  void tellIfWithoutSurface(const ObjectWork& object);
  //! False, and says so, if the active object is locked, or another frame is shown than it is grown in.
  bool mayChange();
  //! False, and says so, if it is locked. Shows the frame that it is grown in.
  bool mayGoOn();

  // --- time ---
  bool isInGrownFrame();
  void growInShown();
  void setGrownFrame(int frame);
  void shownFrameChanged();
  void giveUpGrownFrame();
  std::shared_ptr<const MeshSnapshot> shownOf(const ObjectWork& object) const;
  //! The grown frame is shown while another one is corrected.
  bool showsHome() const { return corrected.isOpen() && time.showsGrownFrame(); }
  //! Whose growth is shown; null: the frame is one that the surface is carried to.
  const ObjectWork* grownHere() const;
  //! What was carried to the shown frame, of the object that there is; null: nothing.
  const CarriedFrame* carriedHere() const;
  void carryAgain(const std::optional<int>& again = {});
  OverTimeSettings carrySettings() const;
  void enter(const CorrectedFrame& frame);
  void leaveCorrection();
  void forgetSavedCorrection();
  std::shared_ptr<ObjectWork> newCorrection(int frame);
  //! What of a session belongs to the grown frame, also while another one is corrected.
  const std::shared_ptr<ObjectWork>& base() const {
    return corrected.isOpen() ? corrected.home() : objects.active();
  }
  std::vector<FrameCorrection> corrections() const;
  //! A session has to keep it: what was asked for, or corrected by hand.
  bool hasOverTime() const;
  void carryAfterReplay();
  OverTimeReport overTimeReport() const;
  void exportFrames(const QString& path, CoordinateSpace space);

  // --- seeds and parameters ---
  void push(const QString& text, Edits after, int gesture);
  void takeOut(ObjectWork& object, const MeshEdit& edit);
  void dropObsolete();
  //! False, and says so, where the active object cannot be pinned now.
  bool mayPin();
  bool pin(const std::vector<WallBall>& stroke, const QString& undoText);
  void goOn(Wanted what);
  bool isAsSaved() const;
  void updateModified();

  // --- out ---
  //! Of work that a session can hold it is a change that is not saved.
  void setOutput(const OutputChoices& choices);
  std::vector<Session> sessions() const;
  //! What an object is called in files: one that there was, too.
  std::string nameInFiles(const std::string& name, bool isAnonymous) const;
  //! Of those that have a surface, in order.
  std::vector<std::string> namesInFiles(bool isAnonymous) const;
  std::vector<PendingReport> pendingReports(bool isAnonymous) const;
  //! `window`: what that keeps.
  QByteArray viewWithObjects(const QByteArray& window) const;
  void readView();
  WrittenObject objectToWrite(const ObjectWork& object, std::shared_ptr<const FinishedMesh> surface) const;
  std::vector<WrittenObject> writtenObjects(const std::vector<int>& which, bool isAnonymous) const;
  //! Tells on the GUI thread what is being polished.
  std::function<void(const std::string&)> polishing();
  //! What is told of files that are written; empty: nothing.
  struct Written {
    QString polished, leftOut;
  };
  //! On the files' thread: has `job` done until it is cancelled, and tells how it ended.
  void write(const QString& path, std::function<Written()> job);
  //! The same of several files. `path`: what signals name.
  void write(const QString& path, const QStringList& all, std::function<Written()> job);
  using WriteObjects = std::function<void(const std::vector<ExportedObject>&, const ExportContext&)>;
  //! `told`: the path that signals name; `paths`: what is written.
  void exportAs(const QString& told, const QStringList& paths, CoordinateSpace space,
                const DicomContent& content, const std::vector<int>& which, WriteObjects writeThem);
  void exportEach(const QString& path, const QString& extension, CoordinateSpace space,
                  const DicomContent& content);
  void exportFiles(const QString& path, CoordinateSpace space, const DicomContent& content,
                   const std::vector<int>& which);
  void exportReport(const QString& path, const std::vector<PendingReport>& reports, bool isAnonymous);
  void saveSession(const QString& path);
  void exportAnonymousSession(const QString& path);
  WrittenState stateToWrite() const;
  void saved(const QString& path, const WrittenState& state);
  void journalNow();
  void tellOfJournal(const QString& why);

  Document& q;

  // What is open, and where it is saved.
  std::optional<OpenedWork> work;
  // Of the volume; read and written by jobs of the files' thread alone. Each work has one of its own, from
  // the moment at which it takes the place of what was open: jobs tell by it whether theirs is open still.
  std::shared_ptr<std::string> hash;
  StopFlag hashing;  // of the job that makes it
  QString sessionPath;
  FileStamp sessionStamp;  // of what was opened or written there last
  QByteArray view;
  bool wasModified = false;
  NewestJob opening, openingObjects;
  JobsUnderWay exporting;
  bool openingWaits = false;
  std::optional<ReadWork> read;  // waits
  int editsAtOpen = 0;           // when what is being opened was asked for
  bool wasModifiedAtOpen = false;
  std::vector<std::weak_ptr<const ObjectWork>> begun;  // what was opened last, while it is prepared
  QStringList withoutSurface;                          // why that is so, of those that failed

  // What is edited, and how that is undone.
  ObjectSet objects;
  QUndoStack undo;
  int edits = 0;  // changes of what is saved; the place in the list may be the same after other ones
  Measurements measurements{undo};

  // Over time.
  TimeSeries time;
  CorrectedFrames corrected;
  bool isCorrectionSaved = false;                 // the session that was written last holds the one under way
  std::weak_ptr<const ObjectWork> carriedObject;  // whose surface `time` has carried
  int growsIn = -1;                               // frame in which to grow when it is shown; -1: none
  bool carriesLater = false;                      // when what a session says has been grown

  GrowthChoices growthChoices;
  OutputChoices output;

  // Threads: last, so that they end before what their jobs report to.
  Journal journal{[this](const QString& why) {
    QMetaObject::invokeMethod(
        &q, [this, why] { tellOfJournal(why); }, Qt::QueuedConnection);
  }};
  Background files;
};

}  // namespace handlebody::ui
