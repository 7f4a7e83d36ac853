#include "ui/model/frame_store.h"

#include <unistd.h>

#include "core/cancellation.h"
#include "ui/model/error_sentence.h"
#include "ui/model/opening.h"

namespace handlebody::ui {

namespace {

constexpr double kShareOfMemory = 0.25;
constexpr std::size_t kMinFrames = 2;  // the one that is shown, and the next

double physicalMemory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double bytesOf(const Volume& volume) {
  return static_cast<double>(volume.grid.voxelCount()) * static_cast<double>(bytesPerVoxel(volume.type));
}

}  // namespace

FrameStore::FrameStore(std::function<void(int, const QString&)> arrived)
    : arrived_(std::move(arrived)), bound_(kShareOfMemory * physicalMemory()) {}

void FrameStore::stop() {
  stop_->all();
  thread_.reset();
}

void FrameStore::start(const std::string& path, const VolumeSelection& selection, int frames, int frame,
                       const Volume& volume, std::shared_ptr<const DicomOrigin> origin) {
  stop();
  const std::lock_guard lock(mutex_);
  source_ = {path, selection, source_.number + 1};
  frames_ = frames;
  kept_.clear();
  kept_.push_front({frame, volume});
  origins_ = {{frame, std::move(origin)}};
}

std::shared_ptr<const DicomOrigin> FrameStore::origin(int frame) const {
  const std::lock_guard lock(mutex_);
  const auto found = origins_.find(frame);
  return found == origins_.end() ? nullptr : found->second;
}

std::optional<Volume> FrameStore::kept(int frame) { return find(frame); }

std::optional<Volume> FrameStore::find(int frame) {
  const std::lock_guard lock(mutex_);
  for (auto it = kept_.begin(); it != kept_.end(); ++it)
    if (it->frame == frame) {
      kept_.splice(kept_.begin(), kept_, it);
      return kept_.front().volume;
    }
  return std::nullopt;
}

void FrameStore::want(int frame) {
  stop_->all();
  stop_ = std::make_shared<Stop>();
  if (!thread_) thread_ = std::make_unique<Background>();
  thread_->postInstead([this, frame, stop = stop_] { decodeAhead(frame, *stop); });
}

void FrameStore::decodeAhead(int frame, const Stop& stop) {
  const Source from = source();
  for (int i = 0; i < frames_; ++i) {
    const std::atomic<bool>& cancelled = i == 0 ? stop.wanted : stop.ahead;
    const CancelScope scope(cancelled);
    if (cancelled) return;
    const int now = (frame + i) % frames_;
    if (i > 0 && !hasRoom()) return;
    {
      const std::lock_guard lock(mutex_);
      bool isKept = false;
      for (const Kept& k : kept_) isKept = isKept || k.frame == now;
      if (isKept && i > 0) continue;
    }
    try {
      if (!find(now)) keep(from, now, decode(from, now));
      if (i == 0 && !cancelled) arrived_(now, {});
    } catch (const Cancelled&) {
      return;
    } catch (...) {
      if (i == 0 && !cancelled) arrived_(now, errorSentence());
    }
  }
}

Volume FrameStore::load(int frame) {
  if (auto volume = find(frame)) return *volume;
  const Source from = source();
  LoadedVolume loaded = decode(from, frame);
  if (hasRoom()) keep(from, frame, loaded);
  return loaded.volume;
}

FrameStore::Source FrameStore::source() const {
  const std::lock_guard lock(mutex_);
  return source_;
}

LoadedVolume FrameStore::decode(Source source, int frame) {
  source.selection.frame = frame;
  const std::lock_guard lock(readingVolumes());
  giveUpIfCancelled();
  return loadVolume(source.path, source.selection);
}

void FrameStore::keep(const Source& source, int frame, const LoadedVolume& loaded) {
  const std::lock_guard lock(mutex_);
  if (source.number != source_.number) return;
  for (const Kept& k : kept_)
    if (k.frame == frame) return;
  kept_.push_front({frame, loaded.volume});
  origins_[frame] = loaded.info.dicom;
  double sum = 0;
  std::size_t fits = 0;
  for (const Kept& k : kept_) {
    sum += bytesOf(k.volume);
    if (sum > bound_ && fits >= kMinFrames) break;
    ++fits;
  }
  while (kept_.size() > fits) kept_.pop_back();
}

bool FrameStore::hasRoom() const {
  const std::lock_guard lock(mutex_);
  if (kept_.empty()) return true;
  double sum = bytesOf(kept_.front().volume);  // of one more
  for (const Kept& k : kept_) sum += bytesOf(k.volume);
  return sum <= bound_;
}

void FrameStore::setBound(double bytes) {
  const std::lock_guard lock(mutex_);
  bound_ = bytes;
}

double FrameStore::bytes() const {
  const std::lock_guard lock(mutex_);
  double sum = 0;
  for (const Kept& k : kept_) sum += bytesOf(k.volume);
  return sum;
}

}  // namespace handlebody::ui
