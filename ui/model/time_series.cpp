#include "ui/model/time_series.h"

#include <algorithm>
#include <cmath>

#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/sequence/cycle_check.h"
#include "ui/model/error_sentence.h"
#include "ui/model/finished_mesh.h"
#include "ui/model/opening.h"

namespace handlebody::ui {

namespace {

constexpr int kUsualStep = 100, kShortestStep = 20, kLongestStep = 1000;  // ms between frames that are played

int stepOf(const TimeAxis& times) {
  const std::vector<double>& t = times.milliseconds;
  if (t.size() < 2) return kUsualStep;
  const double mean = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  return static_cast<int>(std::clamp(mean, double(kShortestStep), double(kLongestStep)));
}

//! From `frame` towards `start`, whose own is there.
int nearestTrusted(const std::map<int, FrameResult>& results, int frame, int start) {
  for (; frame != start; frame += frame < start ? 1 : -1)
    if (const auto found = results.find(frame); found != results.end() && found->second.startsNext()) break;
  return frame;
}

FrameResult withoutMesh(FrameResult result) {
  result.mesh = {};
  return result;
}

CarriedFrame shownAs(FrameResult result) {
  CarriedFrame frame{std::move(result), nullptr, nullptr};
  const TriangleSoup& mesh = frame.result.mesh;
  if (mesh.triangles.empty()) return frame;
  auto snapshot = std::make_shared<MeshSnapshot>();
  snapshot->iteration = frame.result.iterations;
  snapshot->mesh = mesh;
  snapshot->states.assign(mesh.triangles.size(), FaceState::converged);
  snapshot->certificate = certify(mesh);
  snapshot->edgeLength = frame.result.under.edgeLength;
  snapshot->pinned = frame.result.under.pinned;
  for (const ToldFault& f : frame.result.faults) snapshot->warnings.push_back(f.finding);
  frame.snapshot = std::move(snapshot);
  frame.finished = std::make_shared<const FinishedMesh>(frame.snapshot);
  return frame;
}

}  // namespace

struct TimeSeries::Job {
  std::atomic<bool> cancelled{false};
  int done = 0, all = 1;  // frames; the GUI thread's
};

TimeSeries::TimeSeries(QObject* parent)
    : QObject(parent), store_([this](int frame, const QString& error) {
        QMetaObject::invokeMethod(
            this, [this, frame, error] { arrived(frame, error); }, Qt::QueuedConnection);
      }) {
  connect(&timer_, &QTimer::timeout, this, &TimeSeries::tick);
}

TimeSeries::~TimeSeries() {
  if (carrying_) carrying_->cancelled = true;
}

// --- time ---

void TimeSeries::start(const OpenedWork& work) {
  cancel();
  timer_.stop();
  frames_ = std::max(1, work.info.frames);
  grown_ = work_ = shown_ = wanted_ = std::clamp(work.reference.selection.frame.value_or(0), 0, frames_ - 1);
  times_ = work.times;
  volume_ = workVolume_ = work.volume;
  error_.clear();
  request_ = {};
  isAsked_ = false;
  forgetCarried();
  store_.start(work.reference.path, work.reference.selection, frames_, shown_, volume_, work.info.dicom);
  Q_EMIT playingChanged();
  Q_EMIT requestChanged();
  Q_EMIT wantedChanged();
  Q_EMIT shownChanged();
}

std::optional<double> TimeSeries::timeOf(int frame) const {
  const auto at = static_cast<std::size_t>(frame);
  return at < times_.milliseconds.size() ? std::optional(times_.milliseconds[at]) : std::nullopt;
}

void TimeSeries::setGrownFrame() {
  if (grown_ == shown_) return;
  grown_ = work_ = shown_;
  workVolume_ = volume_;
  forgetCarried();
  Q_EMIT shownChanged();
}

void TimeSeries::setWorkFrame(int frame, const Volume& volume) {
  work_ = frame;
  workVolume_ = volume;
}

void TimeSeries::show(int frame) {
  if (frames_ < 1) return;
  frame = std::clamp(frame, 0, frames_ - 1);
  if (frame == wanted_ && (frame == shown_ || error_.isEmpty())) return;
  wanted_ = frame;
  error_.clear();
  Q_EMIT wantedChanged();
  if (frame == work_)
    showNow(frame, workVolume_);
  else if (const auto volume = store_.kept(frame))
    showNow(frame, *volume);
  else
    store_.want(frame);
}

void TimeSeries::arrived(int frame, const QString& error) {
  if (frame != wanted_ || frame == shown_) return;
  if (!error.isEmpty()) {
    error_ = error;
    play(false);
    Q_EMIT wantedChanged();
  } else if (const auto volume = store_.kept(frame)) {
    showNow(frame, *volume);
  }
}

void TimeSeries::showNow(int frame, const Volume& volume) {
  shown_ = frame;
  volume_ = volume;
  Q_EMIT shownChanged();
}

void TimeSeries::play(bool on) {
  on = on && hasTime();
  if (on == isPlaying()) return;
  if (on) {
    timer_.start(stepOf(times_));
    store_.want(wanted_);  // and those behind it
  } else {
    timer_.stop();
  }
  Q_EMIT playingChanged();
}

void TimeSeries::tick() {
  if (shown_ == wanted_) show((shown_ + 1) % frames_);
}

// --- over time ---

void TimeSeries::setRequest(const OverTimeRequest& request, bool isAsked) {
  if (request == request_ && isAsked == isAsked_) return;
  request_ = request;
  isAsked_ = isAsked;
  Q_EMIT requestChanged();
}

OverTimeRequest::Range TimeSeries::range() const {
  OverTimeRequest::Range range = request_.frames.value_or(OverTimeRequest::Range{0, frames_ - 1});
  range.first = std::clamp(range.first, 0, grown_);
  range.last = std::clamp(range.last, grown_, std::max(grown_, frames_ - 1));
  return range;
}

const CarriedFrame* TimeSeries::carriedTo(int frame) const {
  const auto found = carried_.find(frame);
  return found == carried_.end() ? nullptr : &found->second;
}

double TimeSeries::progress() const {
  return carrying_ ? static_cast<double>(carrying_->done) / std::max(1, carrying_->all) : 0;
}

void TimeSeries::forgetCarried() {
  cancel();
  const bool any = !carried_.empty() || from_;
  carried_.clear();
  drifts_.clear();
  from_.reset();
  start_ = {};
  carryError_.clear();
  if (any) Q_EMIT carriedChanged();
}

void TimeSeries::cancel() {
  if (!carrying_) return;
  carrying_->cancelled = true;
  carrying_.reset();
  Q_EMIT carryingChanged();
}

void TimeSeries::carry(CarryOrder order) {
  cancel();
  const auto isBeyond = [&](int frame) {
    return !order.again || (*order.again > grown_ ? frame >= *order.again : frame <= *order.again);
  };
  std::erase_if(carried_, [&](const auto& c) { return isBeyond(c.first); });
  drifts_.clear();
  carryError_.clear();
  from_ = order.surface;
  start_ = order.start;
  carriedWith_ = request_;
  carriedWith_.frames = range();
  auto job = std::make_shared<Job>();
  const OverTimeRequest::Range all = range();
  int first = all.first, last = all.last;
  if (order.again) (*order.again > grown_ ? first : last) = *order.again + (*order.again > grown_ ? -1 : 1);
  job->all = last - first;
  if (request_.drift == DriftCheck::back) job->all += all.last - all.first;
  if (request_.drift == DriftCheck::wrap) job->all += 1;
  carrying_ = job;
  if (!carrier_) carrier_ = std::make_unique<Background>();
  carrier_->postInstead([this, order = std::move(order), all, check = request_.drift, known = known(), job] {
    work(order, all, check, known, job);
  });
  Q_EMIT carriedChanged();
  Q_EMIT carryingChanged();
}

std::map<int, FrameResult> TimeSeries::known() const {
  std::map<int, FrameResult> results;
  for (const auto& [frame, carried] : carried_) results[frame] = carried.result;
  return results;
}

//! On the carrier's thread.
void TimeSeries::work(const CarryOrder& order, const OverTimeRequest::Range& range, DriftCheck check,
                      std::map<int, FrameResult> results, const std::shared_ptr<Job>& job) {
  const auto tell = [&](const FrameResult& result, bool isOnTheWay) {
    auto frame = std::make_shared<CarriedFrame>(isOnTheWay ? shownAs(result) : CarriedFrame{});
    QMetaObject::invokeMethod(
        this, [this, job, frame, isOnTheWay] { took(job, *frame, isOnTheWay); }, Qt::QueuedConnection);
  };
  std::vector<Drift> drifts;
  QString error;
  try {
    const CancelScope scope(job->cancelled);
    giveUpIfCancelled();
    FrameResult start = order.start;
    start.mesh = order.surface->get().mesh;
    const FrameCarrier carrier(order.settings,
                               {[this](int frame) { return store_.load(frame); },
                                [](const TriangleSoup& mesh) { return certifiedForExport(mesh).mesh; }});
    const Certificate& c = order.surface->get().certificate;
    start.volume = c.volume;
    start.components = c.components;
    for (const int g : c.genus) start.genus += g;
    QMetaObject::invokeMethod(
        this,
        [this, job, known = withoutMesh(start)] {
          if (job == carrying_) start_ = known;
        },
        Qt::QueuedConnection);
    results[start.frame] = start;
    const auto through = [&](int last) {
      const int from = order.again && (*order.again > start.frame) == (last > start.frame)
                           ? nearestTrusted(results, *order.again, start.frame)
                           : start.frame;
      for (const FrameResult& r :
           carryThrough(carrier, results.at(from), last, [&](const FrameResult& r) { tell(r, true); }))
        results[r.frame] = r;
    };
    if (!order.again || *order.again < start.frame) through(range.first);
    if (!order.again || *order.again > start.frame) through(range.last);
    std::vector<FrameResult> frames;
    for (int f = range.first; f <= range.last; ++f)
      if (results.count(f) > 0) frames.push_back(results.at(f));
    const bool isWhole = static_cast<int>(frames.size()) == range.last - range.first + 1;
    if (isWhole)
      drifts = checkCycle(carrier, frames, start, check, order.settings.edgeLength,
                          [&](const FrameResult& r) { tell(r, false); });
  } catch (const Cancelled&) {
    return;
  } catch (...) {
    error = errorSentence();
  }
  QMetaObject::invokeMethod(
      this, [this, job, error, drifts] { ended(job, error, drifts); }, Qt::QueuedConnection);
}

void TimeSeries::took(const std::shared_ptr<Job>& job, const CarriedFrame& frame, bool isOnTheWay) {
  if (job != carrying_) return;  // it was cancelled
  ++job->done;
  if (isOnTheWay) {
    carried_[frame.result.frame] = frame;
    Q_EMIT carriedChanged();
  } else {
    Q_EMIT carryingChanged();
  }
}

void TimeSeries::ended(const std::shared_ptr<Job>& job, const QString& error, std::vector<Drift> drifts) {
  if (job != carrying_) return;
  carrying_.reset();
  carryError_ = error;
  drifts_ = std::move(drifts);
  Q_EMIT carriedChanged();
  Q_EMIT carryingChanged();
}

bool TimeSeries::isAsRequested() const {
  OverTimeRequest now = request_;
  now.frames = range();
  now.drift = carriedWith_.drift;          // is no matter of the surfaces,
  now.frameTime = carriedWith_.frameTime;  // nor is this
  return now == carriedWith_;
}

const FrameResult* TimeSeries::resultOf(int frame) const {
  if (frame == grown_) return from_ ? &start_ : nullptr;
  const CarriedFrame* carried = carriedTo(frame);
  return carried ? &carried->result : nullptr;
}

bool TimeSeries::isComplete() const {
  const OverTimeRequest::Range all = range();
  return from_ && all.first != all.last && framesOfRange(false).empty();
}

std::vector<int> TimeSeries::framesOfRange(bool areThere) const {
  std::vector<int> frames;
  const OverTimeRequest::Range all = range();
  for (int f = all.first; f <= all.last; ++f)
    if ((resultOf(f) != nullptr) == areThere) frames.push_back(f);
  return frames;
}

VolumeCurve TimeSeries::curve() const {
  std::vector<VolumePoint> points;
  const auto add = [&](const FrameResult& r, bool isThere) {
    points.push_back({r.frame, timeOf(r.frame), isThere ? std::optional(r.volume) : std::nullopt,
                      isThere && std::none_of(r.faults.begin(), r.faults.end(),
                                              [](const ToldFault& f) { return isFailure(f.fault); })});
  };
  bool isGrownThere = !from_;
  for (const auto& [frame, carried] : carried_) {
    if (!isGrownThere && frame > grown_) add(start_, true);
    isGrownThere = isGrownThere || frame > grown_;
    add(carried.result, carried.snapshot != nullptr);
  }
  if (!isGrownThere) add(start_, true);
  return volumeCurve(std::move(points));
}

OverTimeReport TimeSeries::report() const {
  OverTimeReport report;
  if (!from_) return report;
  report.request = carriedWith_;
  report.request.frameTime = request_.frameTime;
  report.times = times_;
  std::map<int, FrameResult> results = known();
  results[grown_] = start_;
  results[grown_].mesh = from_->shown()->mesh;
  for (auto& [frame, result] : results) report.frames.push_back(std::move(result));
  report.curve = curveOf(report.frames, times_);
  report.drifts = drifts_;
  return report;
}

}  // namespace handlebody::ui
