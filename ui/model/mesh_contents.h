#pragma once
// What a shown mesh holds that can be edited: its components, cavities and tunnels, looked for on a thread of
// its own.

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "core/mesh/pieces.h"
#include "ui/model/background.h"
#include "ui/model/document.h"

namespace handlebody::ui {

//! A tunnel with its loops as polygons, mm LPS.
struct FoundTunnel {
  Vec3 place{0, 0, 0};
  std::vector<Vec3> handle, tunnel;                  //!< around the handle, and round the tunnel
  double handleLength = 0, tunnelLength = 0;         //!< mm
  bool canCutHandle = false, canFillTunnel = false;  //!< false for a knotted one
};

struct FoundPiece {
  Piece piece;
  Vec3 place{0, 0, 0};  //!< its vertex nearest to its middle
};

struct MeshContents {
  std::shared_ptr<const MeshSnapshot> mesh;
  std::vector<FoundTunnel> tunnels;  //!< the shortest first
  std::vector<FoundPiece> pieces;
  int unlisted = 0;  //!< tunnels for which no loops were found
  QString error{};   //!< why there is nothing; empty: all went well
};

//! Throws Cancelled. Precondition: the mesh passes the certificate.
MeshContents contentsOf(const std::shared_ptr<const MeshSnapshot>& mesh);

class ContentsFinder {
 public:
  ~ContentsFinder() { cancel(); }
  //! `done` is called on the finder's thread, unless it was cancelled; what was looked for before is dropped.
  void find(std::shared_ptr<const MeshSnapshot> mesh, std::function<void(MeshContents)> done);
  void cancel();

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Background thread_;
};

}  // namespace handlebody::ui
