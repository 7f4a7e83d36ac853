#pragma once
// The time points of a 4D volume, decoded on a thread of their own and kept as far as memory allows.

#include <QString>
#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "core/io/formats/volume_io.h"
#include "ui/model/background.h"

namespace handlebody::ui {

//! All calls but load() come from one thread.
class FrameStore {
 public:
  //! `arrived` is called on the store's thread when a frame that was wanted is there, or cannot be read: then
  //! with the sentence that says why.
  explicit FrameStore(std::function<void(int frame, const QString& error)> arrived);
  ~FrameStore() { stop(); }

  //! Another volume; what was kept is let go. `volume` is its time point `frame`, `origin` that one's.
  void start(const std::string& path, const VolumeSelection& selection, int frames, int frame,
             const Volume& volume, std::shared_ptr<const DicomOrigin> origin = nullptr);
  //! None: it is not kept.
  std::optional<Volume> kept(int frame);
  //! Decodes it next, and then those after it while there is room, round to the first; what was wanted before
  //! is given up. Nothing is told of one that is kept.
  void want(int frame);
  //! As it is kept or by decoding it now, on the thread that calls. Any thread. Throws InputError, Cancelled
  //! (cancellation.h).
  Volume load(int frame);

  //! The DICOM images of a time point that has been decoded since start(); null: there are none.
  std::shared_ptr<const DicomOrigin> origin(int frame) const;

  //! Decodes no frames ahead until one is wanted again.
  void rest() { stop_->ahead = true; }

  //! Bytes of voxels that are kept at most, but at least the two frames used last. At first a quarter of the
  //! machine's memory.
  void setBound(double bytes);
  double bytes() const;  //!< that are kept

 private:
  struct Kept {
    int frame;
    Volume volume;
  };
  void stop();
  //! Of the frame that is wanted, and of those after it.
  struct Stop {
    std::atomic<bool> wanted{false}, ahead{false};
    void all() { wanted = ahead = true; }
  };
  //! What the frames are of.
  struct Source {
    std::string path{};
    VolumeSelection selection{};
    int number = 0;  //!< of the volumes that were open
  };
  Source source() const;
  static LoadedVolume decode(Source source, int frame);
  void decodeAhead(int frame, const Stop& stop);
  //! Not if another volume is open by now.
  void keep(const Source& source, int frame, const LoadedVolume& loaded);
  std::optional<Volume> find(int frame);
  bool hasRoom() const;

  const std::function<void(int, const QString&)> arrived_;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;                                       // the one used last first
  std::map<int, std::shared_ptr<const DicomOrigin>> origins_;  // small: all stay
  Source source_;
  int frames_ = 0;
  double bound_;
  std::shared_ptr<Stop> stop_ = std::make_shared<Stop>();
  std::unique_ptr<Background> thread_;  // last, and from the first frame that is wanted on
};

}  // namespace handlebody::ui
