#pragma once
// The time points of the open volume: which of them is shown, and the surface that was grown in one of them
// carried through the others. Time runs over frames, the timeline of a growth over iterations: neither knows
// of the other.

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/report/over_time_report.h"
#include "ui/model/background.h"
#include "ui/model/frame_store.h"

namespace handlebody::ui {

class FinishedMesh;
struct MeshSnapshot;
struct OpenedWork;

//! A frame that the surface was carried to.
struct CarriedFrame {
  FrameResult result;
  std::shared_ptr<const MeshSnapshot> snapshot;  //!< of its surface, as the views draw it; null: none
  std::shared_ptr<const FinishedMesh> finished;  //!< the same, as it is written; null: none
};

//! What is carried.
struct CarryOrder {
  FrameResult start;  //!< of the frame that was grown, without its mesh
  std::shared_ptr<const FinishedMesh> surface;
  OverTimeSettings settings;
  std::optional<int> again{};  //!< only this frame and those beyond it, seen from the start; none: all
};

//! Lives on the GUI thread; no call waits.
class TimeSeries : public QObject {
  Q_OBJECT

 public:
  explicit TimeSeries(QObject* parent = nullptr);
  ~TimeSeries() override;

  // --- time ---
  //! Another volume is open.
  void start(const OpenedWork& work);
  int frameCount() const { return frames_; }  //!< 0: none is open; 1: it has no time
  bool hasTime() const { return frames_ > 1; }
  const TimeAxis& times() const { return times_; }
  std::optional<double> timeOf(int frame) const;  //!< ms; none: not known
  //! In which the surface is grown.
  int grownFrame() const { return grown_; }
  //! In which the surface is that is being changed: the grown one, or one that is corrected.
  int workFrame() const { return work_; }
  void setWorkFrame(int frame, const Volume& volume);
  bool showsWorkFrame() const { return shown_ == work_; }
  //! The shown frame is that in which it is grown from now on; what was carried is gone.
  void setGrownFrame();
  int shownFrame() const { return shown_; }
  bool showsGrownFrame() const { return shown_ == grown_; }
  const Volume& volume() const { return volume_; }  //!< of the shown frame
  //! As soon as it is decoded; of several that were asked for the newest is shown.
  void show(int frame);
  //! The one that was asked for last.
  int wantedFrame() const { return wanted_; }
  bool isPlaying() const { return timer_.isActive(); }
  //! Frame after frame, round from the last to the first, in the time of the file where that is known; slower
  //! where they are not decoded so fast.
  void play(bool on);
  //! Why the frame that was asked for cannot be shown; empty: it can.
  const QString& error() const { return error_; }
  FrameStore& store() { return store_; }

  // --- over time ---
  const OverTimeRequest& request() const { return request_; }
  bool isAsked() const { return isAsked_; }  //!< the session says it
  void setRequest(const OverTimeRequest& request, bool isAsked);
  //! Of the request, within the volume.
  OverTimeRequest::Range range() const;
  //! In the background: carriedChanged() after each frame, carryingChanged() at the beginning and the end.
  void carry(CarryOrder order);
  //! What has been carried until now is kept.
  void cancel();
  bool isCarrying() const { return carrying_ != nullptr; }
  double progress() const;  //!< 0 … 1
  const QString& carryError() const { return carryError_; }
  void forgetCarried();
  //! Of the frames that have been carried; that of the grown frame is not among them.
  const std::map<int, CarriedFrame>& carried() const { return carried_; }
  const CarriedFrame* carriedTo(int frame) const;
  //! The surface that they were carried from; null: none.
  const std::shared_ptr<const FinishedMesh>& carriedFrom() const { return from_; }
  //! All that there is, the grown frame among it, in the order of frames. Empty if nothing was carried.
  OverTimeReport report() const;
  //! The volumes of all that there is, in the order of frames.
  VolumeCurve curve() const;
  const std::vector<Drift>& drifts() const { return drifts_; }
  //! What is told of a frame: the grown one's or a carried one's; null: it is not there.
  const FrameResult* resultOf(int frame) const;
  //! False if what was carried was asked for otherwise: another range, topology, or correction.
  bool isAsRequested() const;
  //! True if every frame of the range is there.
  bool isComplete() const;
  //! Frames of the range: those that are there, or those that are not. A carry that was cancelled or failed
  //! leaves some out.
  std::vector<int> framesOfRange(bool areThere) const;

 Q_SIGNALS:
  void shownChanged();   //!< another frame is shown, or another is the one that is grown
  void wantedChanged();  //!< another one was asked for, or it cannot be shown
  void playingChanged();
  void carriedChanged();
  void carryingChanged();
  void requestChanged();

 private:
  struct Job;
  void arrived(int frame, const QString& error);
  void showNow(int frame, const Volume& volume);
  void tick();
  void work(const CarryOrder& order, const OverTimeRequest::Range& range, DriftCheck check,
            std::map<int, FrameResult> results, const std::shared_ptr<Job>& job);
  void took(const std::shared_ptr<Job>& job, const CarriedFrame& frame, bool isOnTheWay);
  void ended(const std::shared_ptr<Job>& job, const QString& error, std::vector<Drift> drifts);
  std::map<int, FrameResult> known() const;

  int frames_ = 0, grown_ = 0, work_ = 0, shown_ = 0, wanted_ = 0;
  TimeAxis times_;
  Volume volume_, workVolume_;
  QString error_;
  QTimer timer_;

  OverTimeRequest request_, carriedWith_;  // the latter with its range
  bool isAsked_ = false;
  FrameResult start_;  // with its mesh, once it is carried
  std::shared_ptr<const FinishedMesh> from_;
  std::map<int, CarriedFrame> carried_;
  std::vector<Drift> drifts_;
  std::shared_ptr<Job> carrying_;
  QString carryError_;

  // Threads: last, so that they end before what their jobs use; the carrier uses the store.
  FrameStore store_;
  std::unique_ptr<Background> carrier_;
};

}  // namespace handlebody::ui
