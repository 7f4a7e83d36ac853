#pragma once
// The open work: a volume, and objects with their seeds, parameters and the growth made from them. What the
// views show and the panels change. Lives on the GUI thread; reading and growing run on worker threads and
// never block a call here.

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/evolution/constraints.h"
#include "core/evolution/correction.h"
#include "core/evolution/held_changes.h"
#include "core/evolution/image_warnings.h"
#include "core/evolution/leak_alarm.h"
#include "core/evolution/parameters.h"
#include "core/evolution/pinned_parts.h"
#include "core/evolution/step_report.h"
#include "core/finding.h"
#include "core/io/dicom/dicom_writer.h"
#include "core/io/formats/volume_io.h"
#include "core/io/meshes/exported_object.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/over_time_request.h"
#include "core/mesh/validity.h"
#include "core/sensitivity/sensitivity.h"
#include "core/volume/volume.h"
#include "ui/model/candidate_choice.h"

class QUndoStack;

namespace handlebody::ui {

class FinishedMesh;
class Measurements;
class TimeSeries;

//! What a face of the shown mesh is, for colouring.
enum class FaceState : unsigned char { moving, converged, newHandle, colliding };

//! The mesh after one iteration, as the views draw it. Never changed once it was handed out.
struct MeshSnapshot {
  int iteration = 0;
  TriangleSoup mesh;              //!< mm LPS
  std::vector<FaceState> states;  //!< one per triangle
  SurfaceSupport support;         //!< its faces are the triangles
  Certificate certificate;        //!< of this mesh: every frame that is shown has been looked at
  std::vector<HeldPlace> held;    //!< what vetoes and limits of the topology hold back
  double edgeLength = 0;          //!< mm, the target of its growth
  std::vector<PinnedPart> pinned;
  std::vector<bool> pinnedVertices;  //!< one per point of the mesh: some pin holds it
  //! What the image says against the surface; only of a surface at rest.
  std::vector<Finding> warnings;
};

//! One row of the timeline, cheap to copy; iteration 0 is the seed surface.
struct IterationSummary {
  int iteration = 0;
  double volume = 0;       //!< mm³
  double movingShare = 0;  //!< 0 … 1 of the vertices
  int events = 0;          //!< changes of topology; repairs of the mesh are not counted
  int rollBacks = 0;       //!< places that were taken back
};

//! A narrow passage that the surface came through.
struct FoundLeak {
  Leak leak;
  int before = 0;  //!< the last iteration at which the passage was free
};

//! What somebody has asked for on the way: the surface went on with it from that iteration.
struct ChangeMark {
  int iteration = 0;
  QStringList what;  //!< "Walls", "Pins" …
};

//! A wall that the growth does not know yet lies where the shown surface is already.
struct WallConflict {
  bool canBePushedOut = false;  //!< the surface may move both ways and crosses it
  bool operator==(const WallConflict&) const = default;
};

enum class GrowthState {
  none,       //!< nothing was grown yet, or the volume changed since, or no seed is left
  preparing,  //!< automatic parameters are chosen, the image is smoothed
  paused,
  running,
  finished,  //!< converged or at the iteration limit (see stopReason)
};

//! A row of the list of objects.
struct ObjectInfo {
  ObjectLabel label;
  bool visible = true;
  bool locked = false;  //!< nothing that makes its surface another one is taken
  bool seeded = false;
  GrowthState state = GrowthState::none;
  std::shared_ptr<const MeshSnapshot> snapshot;  //!< null without a growth
  //! The first of the objects before it whose surface was another one when this one was grown, or that was
  //! not among them, or is no more; empty: its surface is made with those that there are.
  QString madeWithEarlier;
};

//! What becomes of a surface that is opened as an object.
enum class OpenAs {
  done,  //!< it is the object as it is: locked, and a wall for the objects after it
  start  //!< it grows onto the image from there, or gives ground
};

//! What of a file becomes objects, and how.
struct ObjectsToOpen {
  QString path;  //!< of a mesh or a label map
  OpenAs as = OpenAs::done;
  std::vector<int> labels{};  //!< of the map, as LabelFile counts them; empty: all
  LabelShape shape{};         //!< of a label map
};

class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  // --- open ---
  //! Reads a volume, DICOM folder, session or report on a worker thread; opening() tells the progress, then
  //! opened() or openFailed(). What is open stays as it is until the new volume is complete, and for good if
  //! that fails. A folder of several series without a choice in `selection` ends in seriesChoiceNeeded(), an
  //! anonymous session in fileNeeded() until `files` has all that it was asked for, in that order.
  void open(const QString& path, const VolumeSelection& selection = {}, const QStringList& files = {});
  //! openingCancelled(), if anything was being opened.
  void cancelOpening();
  bool isOpening() const;
  //! What has been read waits then, told by openingWaits(), until finishOpening() or cancelOpening(): for who
  //! has to ask about the work that is open. False at first: it takes the place of that at once.
  void setOpeningWaits(bool on);
  bool isOpeningWaiting() const;
  //! What has been read and waits takes the place of what is open; nothing if there is none.
  void finishOpening();
  //! Something is unsaved that came after open().
  bool isChangedSinceOpen() const;
  bool hasVolume() const;
  //! Of several time points the shown one. Precondition: hasVolume()
  const Volume& volume() const;
  const VolumeInfo& info() const;  //!< precondition: hasVolume()
  QString path() const;            //!< of the volume
  //! How the volume was read: series, time point, spacing. Precondition: hasVolume()
  const VolumeSelection& selection() const;
  //! What the window keeps in the session for itself (JSON); empty: none. Read it after opened().
  QByteArray view() const;
  void setView(const QByteArray& json);

  // --- objects: one at least; all that comes below but the files is about the active one ---
  // The surface of an object is a wall for those that come after it in the list. One that grows begins when
  // those before it are at rest.
  int objectCount() const;
  int activeObject() const;  //!< index
  ObjectInfo objectInfo(int index) const;
  //! Tells an object from all others, wherever it stands and whatever it is called; the same when undo brings
  //! it back. Expired: it is gone for good.
  std::weak_ptr<const void> objectKey(int index) const;
  //! Where the object with that key stands; -1: not in the list.
  int indexOfObject(const std::weak_ptr<const void>& key) const;
  //! What the objects are called where nothing is to name the patient: those that are called after the file
  //! that they were opened from have another name (core/io/report/anonymous_names.h).
  std::vector<std::string> anonymousNames() const;
  //! No undo entry; what grows goes on. Undoing a change of another object makes that active.
  void setActiveObject(int index);
  //! Behind the others, and active. Name, colour and label value are such as no other has. This one and all
  //! that adds objects: refused() where there is work over time, which no session keeps with several objects.
  void addObject();
  //! What is in a mesh (isMeshInputPath), or what is chosen of a label map of any format, as
  //! objects, in one undo entry: those that are done before the first object that has no surface yet, so that
  //! they are walls for it; else behind the others, the first of them active. Read and made on a worker
  //! thread: openingObjects(), then objectsOpened(), openingObjectsFailed() or openingObjectsCancelled(); of
  //! those that are still being opened, and are given up for these, nothing more is told. While a frame is
  //! corrected, and where there is work over time, openingObjectsFailed() at once. Nothing without a volume.
  void openObjects(const ObjectsToOpen& asked);
  void cancelOpeningObjects();
  //! Behind it, and active: seeds, parameters and constraints, without the growth and the vetoes, pins
  //! and edits of its steps.
  void duplicateObject(int index);
  //! The active one after it is the next in the list. Nothing if it is the last that is left.
  void removeObject(int index);
  void moveObject(int index, int to);
  //! Precondition: objectLabelFault(index, label) is empty.
  void setObjectLabel(int index, const ObjectLabel& label, const QString& undoText, int gesture = -1);
  //! Why the object cannot be called so, as a sentence; empty: it can.
  QString objectLabelFault(int index, const ObjectLabel& label) const;
  void setObjectVisible(int index, bool visible);
  void setObjectLocked(int index, bool locked);
  //! Grows every object that is not done, in their order, and those whose surfaces are made with earlier
  //! ones; none that is locked.
  void runAll();
  //! The object that the active one waits for; empty: it does not wait.
  QString waitsFor() const;

  // --- seeds and parameters; each change is one undo entry with a name ("Move seed") ---
  // Of a locked object nothing is changed, and no click is added that contradicts another: refused() tells.
  // Changes apply to the growth from its shown iteration on: what was grown after it is dropped when it goes
  // on. At iteration 0 it begins again instead. Undoing other clicks with which it has gone on shows the
  // surface as it was when they were made.
  //! All clicks: those inside of the object, from which the surface grows, and those outside of it.
  const std::vector<Seed>& seeds() const;
  //! True if one of them is inside of the object: with clicks outside alone nothing can grow.
  bool isSeeded() const;
  void addSeed(const Seed& seed);
  void removeSeed(int index);
  //! Calls with the same `gesture` (one mouse drag) merge into one undo entry; -1 never merges.
  void moveSeed(int index, const Vec3& centre, int gesture = -1);
  void setSeedRadius(int index, std::optional<double> radius, int gesture = -1);
  int selectedSeed() const;  //!< -1: none
  void selectSeed(int index);
  //! The radius (mm) that a seed has or would be given where it has none; of the resolved seed, if known.
  double shownRadius(int index) const;
  const Parameters& parameters() const;
  //! The likeliest object is taken again where another kind of object is asked for, as with other clicks.
  void setParameters(const Parameters& parameters, const QString& undoText, int gesture = -1);
  //! What the surface may not do.
  const Constraints& constraints() const;
  //! From the shown iteration on.
  void setConstraints(const Constraints& constraints, const QString& undoText, int gesture = -1);
  //! events()[index] is not to happen: goes back to the step before, and what is grown on from there is
  //! without it. Precondition: a change of topology.
  void forbid(int index);
  //! What of the shown snapshot's list is held may happen from the shown iteration on: the veto is lifted, or
  //! the place allowed to break the limits.
  void allow(const HeldPlace& held);
  //! It stays held from the shown iteration on, and nobody is asked about it any more.
  void keepHeld(const HeldPlace& held);
  //! What the limits of the topology hold in the shown iteration, if they ask, and nobody has answered yet;
  //! the earliest first.
  std::vector<HeldPlace> openQuestions() const;
  //! The balls of a stroke are walls from the shown iteration on (painted_walls.h); what lies outside of the
  //! volume is left out. False, with refused(), if nothing of it lies within or a seed would have no room:
  //! nothing has changed then. A growth that runs pauses if the surface is there already (wallConflict()).
  bool paintWalls(const std::vector<WallBall>& stroke);
  //! Balls and discs that one of these balls touches are no walls any more from the shown iteration on.
  void eraseWalls(const std::vector<WallBall>& eraser);
  //! The part of the shown surface in a ball (mm LPS) stays as it is from the shown iteration on. False, with
  //! refused(), if no vertex lies in the ball or it is pinned already; false, too, without a surface or while
  //! it grows: nothing has changed then.
  bool pin(const Vec3& centre, double radius);
  //! The same of the balls of a stroke, as one entry of the undo list; those that hold nothing that is not
  //! held already are left out.
  bool pin(const std::vector<WallBall>& stroke);
  //! Pins that have a vertex of the shown surface in common with one of these balls hold no more from the
  //! shown iteration on. Nothing without a surface or while it grows.
  void unpin(const std::vector<WallBall>& eraser);
  //! Between the walls and the shown surface; none: it can go on. Worked out in the background where walls
  //! were changed or the growth could not go on, told by wallConflictChanged().
  const std::optional<WallConflict>& wallConflict() const;
  //! Back to the last iteration at which the surface had not come to the walls that are new to it, or to the
  //! start, and on from there.
  void goOnBeforeWalls();
  //! Tunnels, components and cavities of the shown mesh, and places on it: goes on from the shown iteration
  //! with that edit as the next step, which is made at once (redo makes it again). Its iteration is set here.
  //! meshEdited(), or refused() and all is as before. Nothing while it grows.
  void editMesh(MeshEdit edit);
  //! The edit of that iteration: goes back to the step before it, and what is grown on from there is without.
  void leaveOutEdit(int iteration);
  //! A wall across leaks()[index]: goes back to before the surface came there, and what is grown on from
  //! there stays on this side.
  void wallAt(int index);
  //! What the automatic parameters come to with the present seeds; worked out in the background after every
  //! change, told by resolvedChanged(). Empty while unknown or where it failed (resolveError()).
  const std::optional<ResolvedParameters>& resolved() const;
  QString resolveError() const;
  //! The object that the surface is driven into; known and told as resolved() is, null while unknown.
  std::shared_ptr<const ObjectImage> objectImage() const;
  //! The objects that the clicks may mean, and the one that is or will be used. Known and told as resolved()
  //! is, but kept while another one of them is prepared.
  CandidateChoice candidateChoice() const;
  //! Takes the next smaller or larger of them; nothing if there is none.
  void chooseCandidate(SizeStep step);
  QUndoStack* undoStack() const;

  //! Rulers and angles, of all objects together; their changes are undo entries, too.
  Measurements& measurements() const;

  // --- time: of a volume with several time points (time_series.h) ---
  // Volume, surface and numbers are those of the shown frame. What is changed is the growth in its own frame,
  // which must be shown for that; the first click in another frame makes that the one it is grown in.
  TimeSeries& time() const;
  //! Moves the clicks of all objects to the shown frame; what was grown is gone. refused() while one of them
  //! is locked.
  void growInShownFrame();
  //! The other objects whose surfaces would be gone then.
  QStringList lostElsewhere() const;
  //! Carries the surface through the other frames, in the background. Nothing where carryFault() says why.
  void carryOverTime();
  //! Why the surface cannot be carried now, as a sentence; empty: it can.
  QString carryFault() const;
  //! What was carried started from the surface that is shown in the frame it is grown in.
  bool isCarriedCurrent() const;
  //! The shown surface was carried to its frame from another one than there is in the grown frame now, or not
  //! as is asked for now.
  bool isShownOutOfDate() const;
  // What the shown surface of the active object was made with: in the frame that is changed what is edited.
  //! In a frame that it was carried to those that were walls there; where there is no surface those of the
  //! grown frame, with which it would be carried.
  const WallList& shownWalls() const;
  //! Pins name an iteration of one frame's growth: a carried surface has none.
  const std::vector<Pin>& shownPins() const;
  //! Clicks belong to the frame that is changed: in any other one there are none.
  const std::vector<Seed>& shownSeeds() const;
  //! The shown frame, to which the surface was carried, becomes the one that is changed, with its own clicks,
  //! walls and edits; it is grown again from the surface of the frame beside it. Nothing where
  //! correctionFault() says why.
  void correctShownFrame();
  QString correctionFault() const;
  std::optional<int> correctedFrame() const;  //!< that is being corrected
  //! Back to the grown frame. `keeps`: the correction counts, and the frames beyond it are carried again.
  void endCorrection(bool keeps);
  //! As an entry of the undo list; refused() where there are several objects.
  void setOverTime(const OverTimeRequest& request, const QString& undoText, int gesture = -1);
  //! Why the surfaces of the frames cannot be written now, as a sentence: of some of them there is none, and
  //! those behind would stand in their place, or a phase of a part be taken for one of the whole. Empty: they
  //! can.
  QString framesFault() const;
  //! The surfaces of all frames, as numbered meshes or a 4D label map by extension; polished, told and
  //! cancelled as exportResult(): all of them are written, or nothing.
  void exportFrames(const QString& path, CoordinateSpace space);

  // --- growth ---
  GrowthState state() const;
  StopReason stopReason() const;
  QString growthError() const;  //!< why the last attempt to grow failed; empty if it did not
  void run();
  void pause();
  void stepForward();
  void stepBack();
  void goTo(int iteration);  //!< any iteration from 0 to lastIteration(); exact
  void goToNextEvent();      //!< runs on if none is recorded yet
  void goToPreviousEvent();
  void goToStart();
  //! While it runs a frame is shown every so many iterations, or later if the views are slower. 1 at first.
  void setStepsPerFrame(int steps);
  int stepsPerFrame() const;
  //! Whether it pauses where it has come through a narrow passage, when it is grown for the first time. False
  //! at first.
  void setPausesAtLeaks(bool on);
  bool pausesAtLeaks() const;
  //! Of all iterations recorded so far, in order.
  const std::vector<FoundLeak>& leaks() const;
  int iteration() const;      //!< shown; -1 without a growth
  int lastIteration() const;  //!< recorded so far; -1 without a growth
  //! The shown iteration; null without a growth.
  std::shared_ptr<const MeshSnapshot> snapshot() const;
  const std::vector<IterationSummary>& summaries() const;  //!< index = iteration
  //! How the surface went on with other clicks, where it did.
  const std::vector<RecordedCorrection>& corrections() const;
  //! Where somebody has changed or corrected the growth on its way, in order.
  std::vector<ChangeMark> changeMarks() const;
  const std::vector<Event>& events() const;  //!< of all iterations, in order, without traces
  //! Works out the stages of events()[index] in the background, told by eventTraced(index, trace).
  void requestTrace(int index);

  //! What the active object's shown iteration was made of; none without a growth.
  std::optional<GrownFrom> grownFrom() const;

  // --- out ---
  //! The shown surface of an object as it is written, by whatever thread asks for it first; null without one.
  std::shared_ptr<const FinishedMesh> finishedMesh(int index) const;
  //! Why no file of this ending (".msh") can be made of the open volume, as a sentence; empty: it can.
  QString exportFault(const QString& extension) const;
  //! Why no file may be written there, as a sentence: it is one that the open work is read from, or would be
  //! a part of its volume. Empty: it may. All that is written below is refused so; whoever else writes asks.
  QString outputFault(const QString& path) const;
  //! Thin triangles of what is written are bettered (core/polish), in files and report alike. True at first,
  //! as on the command line; a session keeps it.
  bool polishes() const;
  void setPolishes(bool on);
  //! Of the mesh files: what the last one was written in; a session keeps it.
  CoordinateSpace space() const;
  //! Mesh or label map by extension, of the shown iteration, written on a worker thread: exporting(), then
  //! exported(), exportFailed() or exportCancelled(); or exportRefused() at once.
  void exportResult(const QString& path, CoordinateSpace space, const DicomContent& content = {});
  //! Why all objects cannot be written now, together, alone or as a report, as a sentence: one of them still
  //! grows. Empty: they can.
  QString allFault() const;
  //! The same of all objects that have a surface, in one file; not if two of them meet.
  void exportObjects(const QString& path, CoordinateSpace space, const DicomContent& content = {});
  //! Where exportEachObject() writes them; `extension`: with which the path ends.
  QStringList objectPaths(const QString& path, const QString& extension, bool anonymous) const;
  //! The same, a file for each of them: the path and before its extension the name of the object.
  void exportEachObject(const QString& path, const QString& extension, CoordinateSpace space,
                        const DicomContent& content = {});
  //! Of all files that are being written, or wait for those before them, nothing is left; nothing if there is
  //! none.
  void cancelExport();
  //! Of all objects that have a surface; tells as exportResult(). `anonymous`: without what may name the
  //! patient, as in the files above if the content says so.
  void exportReport(const QString& path, bool anonymous = false);
  //! Why no session can be written now, as a sentence; empty: it can.
  QString sessionFault() const;
  //! What `handlebody-cli replay` needs to make the shown meshes again; of an object that is still grown
  //! again as a session says, or paused on that way, all that this says. Throws nothing; saveFailed() tells
  //! why.
  void saveSession(const QString& path);
  //! The same without what may name the patient: no file, no series, and the names that objects have from
  //! files (core/io/report/anonymous_names.h). Whoever opens it is asked for its volume. Not the session that
  //! is open from then on; tells as exportResult().
  void exportAnonymousSession(const QString& path);
  //! Objects whose shown surface a replay does not make: of several, those with seeds that are not grown yet
  //! or are made with earlier ones, and those after them.
  QStringList notReplayed() const;
  //! What of the open work no session holds, as a sentence; empty: all is in it.
  QString leftOut() const;
  QString sessionPath() const;  //!< where to save again; empty: nowhere yet, or it is an anonymous one
  //! The file there is not the one that was opened or saved here last: somebody else has written it.
  bool isSessionChangedElsewhere() const;
  bool isModified() const;  //!< since the session was saved or opened

  // --- crash recovery ---
  //! Journals that ended without a clean close, newest first (paths to session files).
  static QStringList recoverable();
  //! open() takes a journal as it takes a session; what was recovered counts as modified and has no session
  //! file. It goes by itself once the journal of what was opened is written. Discard it when it is not
  //! wanted.
  static void discardRecoverable(const QString& journal);

 Q_SIGNALS:
  void opening(const QString& path, double progress);  //!< 0 … 1, negative: unknown
  void openingWaits();
  void openingCancelled();
  void opened();
  void openFailed(const QString& sentence, bool needsSpacing);  //!< the second as in OpeningFailed
  void openingObjects(const QString& path);
  //! `shared`: voxels that several of them hold, and that were left to the smallest (sharedVoxels), together.
  void objectsOpened(const QString& path, const QStringList& names, qint64 shared);
  void openingObjectsFailed(const QString& sentence);
  void openingObjectsCancelled();
  //! The session at `path` does not name one of its files: the rest as in FileNeeded.
  void fileNeeded(const QString& path, handlebody::FindingKind missing, const QString& refused,
                  const QStringList& taken);
  void seriesChoiceNeeded(const QString& path, const std::vector<handlebody::SeriesInfo>& series);
  void seedsChanged();
  void selectedSeedChanged(int index);
  void parametersChanged();
  void constraintsChanged();
  void wallConflictChanged();  //!< a growth that ran into one has paused
  void resolvedChanged();
  void frameShown();           //!< another time point is shown, or grown in; followed by snapshotChanged()
  void objectsChanged();       //!< the list, or what is told of or drawn for one that is not active
  void activeObjectChanged();  //!< followed by all signals of what is about the active one
  void refused(const QString& sentence);
  void stateChanged();
  void snapshotChanged();            //!< another iteration is shown
  void summariesChanged();           //!< lastIteration() moved, or the tail was dropped
  void meshEdited();                 //!< the shown iteration is an edit that was just made
  void leaked(int index);            //!< leaks()[index] was found just now
  void leakedElsewhere(int object);  //!< one that is not active came through a narrow passage just now
  void asked();                      //!< openQuestions() has one that was found just now: the growth paused
  void askedElsewhere(int object);   //!< the same of one that is not active
  void eventTraced(int index, const handlebody::EventTrace& trace);
  void exporting(const QString& path);
  void exportPolishes(const QString& object);  //!< its surface is polished now
  void polished(const QString& sentences);     //!< what that did, before exported(); not if nothing was bad
  void leftOutOfLabelMap(const QString& sentences);  //!< the same of what voxels leave out of the surfaces
  void polishesChanged();
  void exportCancelled(const QString& path);
  void exported(const QString& path);
  void exportFailed(const QString& sentence);
  void exportRefused(const QString& sentence);  //!< nothing was begun: exporting() was not told
  void sessionSaved(const QString& path);
  void saveFailed(const QString& sentence);
  void modifiedChanged();
  //! A crash would lose what is done now. Told again only if it could be kept in between.
  void journalFailed(const QString& sentence);

 private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace handlebody::ui
