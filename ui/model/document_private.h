#pragma once
// The parts of a Document and how they are joined. Only for document*.cpp.

#include <QTimer>
#include <QUndoStack>

#include "core/io/report.h"
#include "ui/model/background.h"
#include "ui/model/document.h"
#include "ui/model/growth.h"
#include "ui/model/journal.h"
#include "ui/model/opening.h"
#include "ui/model/preparation.h"
#include "ui/model/undo_commands.h"

namespace handlebody::ui {

class Document::Private {
 public:
  //! What is to be done when the contour is prepared.
  enum class Wanted { nothing, run, step, toEvent, replay };

  explicit Private(Document& document);
  ~Private();

  // --- opening ---
  void open(const QString& path, const VolumeSelection& selection);
  void finishOpening(int number, const QString& path, OpeningResult result);
  void adopt(const QString& path, OpenedWork opened);
  void adoptSession(const QString& path, const Session& session);
  void hashInBackground();

  // --- seeds and parameters ---
  void push(const QString& text, Edits after, int gesture);
  void apply(const Edits& after, EditCommand::Way way);
  void editsChanged(bool seeds);
  void goBackBefore(const Request& undone);

  // --- automatic parameters ---
  void requestPreparation(const Request& request);
  void preparationDone(int number, const Prepared& result);
  void preparationDue();
  void forgetPreparation();
  void forgetCandidates();

  // --- growth ---
  void goOn(Wanted what);
  void beginGrowth(Wanted what);
  void await(Wanted what);
  void startPrepared();
  void dropGrowth();
  void growthStateChanged();
  GrowthState state() const;
  void updateState();
  void updateModified();

  // --- out ---
  Session session() const;
  RunReport report() const;
  void saveSession(const QString& path);
  void exportReport(const QString& path);
  void journalNow();

  Document& q;

  std::optional<OpenedWork> work;
  std::shared_ptr<std::string> hash;  // of the volume; used by jobs of the files' thread alone
  QString sessionPath;
  QByteArray view;
  int openings = 0;  // number of the newest
  bool isOpening = false;
  std::shared_ptr<std::atomic<bool>> cancelled = std::make_shared<std::atomic<bool>>(false);

  Edits edits;
  QUndoStack undo;
  int savedIteration = -1;
  bool wasModified = false;

  int preparations = 0;  // number of the newest that was asked for
  bool isPreparing = false;
  bool changedOnTheWay = false;                   // clicks or parameters, while the growth runs
  std::shared_ptr<const ActiveContour> prepared;  // of the present clicks and parameters
  double prepareSeconds = 0;
  std::optional<ResolvedParameters> resolved;
  std::vector<ObjectCandidate> candidates;
  bool isCloseChoice = false;
  QString resolveError;
  QTimer settle;  // from the last change to the preparation

  Wanted wanted = Wanted::nothing;
  Replay replay;
  Request replayed;  // at the beginning of the replay
  QString error;
  GrowthState shownState = GrowthState::none;
  StopReason shownStop = StopReason::running;
  QString shownError;
  int stepsPerFrame = 1;

  // Threads: last, so that they end before what their jobs report to.
  Journal journal;
  Growth growth;
  Preparation preparation;
  Background files;
};

}  // namespace handlebody::ui
