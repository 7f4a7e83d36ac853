#pragma once
// A few frames of the beating phantom on disk, and a document in which the surface is grown in one of them.

#include "core/io/formats/sequence_writer.h"
#include "sample_volumes/beating.h"
#include "tests/ui/model/output_support.h"
#include "ui/model/time_series.h"

namespace handlebody::ui {

struct BeatingFile {
  static constexpr int kFrames = 5;
  QTemporaryDir folder;
  QString path;
  Vec3 seed;

  //! `blank`: a frame without anything in it; -1: none.
  explicit BeatingFile(int blank = -1) : path(folder.filePath(QStringLiteral("heart.nii.gz"))) {
    BeatingOptions options;
    options.frames = kFrames;
    options.image.spacing = Vec3::Constant(3);
    const BeatingPhantom phantom(options);
    seed = phantom.seed();
    SequenceLayout layout;
    layout.grid = phantom.grid();
    layout.type = phantom.image(0).type;
    layout.frames = kFrames;
    layout.times = evenTimes(kFrames, 200, "phantom");
    writeSequence(layout, path.toStdString(), [&](int frame) {
      if (frame != blank) return phantom.image(frame);
      void* zeros = nullptr;
      return makeVolume(layout.grid, layout.type, &zeros);
    });
  }
  QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
};

inline bool showFrame(Document& document, int frame) {
  document.time().show(frame);
  return waitFor([&] { return document.time().shownFrame() == frame; });
}

//! Opened, and grown in that frame.
inline bool growInFrame(Document& document, const BeatingFile& heart, int frame = 0) {
  if (!openAndWait(document, heart.path) || !showFrame(document, frame)) return false;
  document.addSeed({heart.seed, {}});
  return runToEnd(document);
}

inline bool carryAll(Document& document) {
  document.carryOverTime();
  return waitFor([&] { return !document.time().isCarrying(); }, 200);
}

}  // namespace handlebody::ui
