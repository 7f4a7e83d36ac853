#include "core/io/report/polished_frames.h"

#include <algorithm>

#include "core/cancellation.h"
#include "core/io/report/polished_export.h"

namespace handlebody {

namespace {

void add(const PolishCount& count, PolishCount& sum) {
  sum.faces += count.faces;
  sum.edges += count.edges;
  sum.leastAngle = std::min(sum.leastAngle, count.leastAngle);
  sum.leastDihedral = std::min(sum.leastDihedral, count.leastDihedral);
}

}  // namespace

void polishFrames(OverTimeReport& over, const std::function<void(int)>& polishing) {
  for (FrameResult& r : over.frames) {
    if (r.mesh.triangles.empty() || over.polish.count(r.frame) > 0) continue;
    giveUpIfCancelled();
    if (polishing) polishing(r.frame);
    CertifiedMesh made{std::move(r.mesh), {}};
    over.polish[r.frame] = polish(made, polishOptions(r.under, made.mesh));
    r.mesh = std::move(made.mesh);
  }
}

PolishReport together(const std::map<int, PolishReport>& frames) {
  PolishReport all;
  for (const auto& [frame, report] : frames) {
    add(report.before, all.before);
    add(report.after, all.after);
    all.limit = std::max(all.limit, report.limit);
    all.farthest = std::max(all.farthest, report.farthest);
    all.changedFaces += report.changedFaces;
    all.isCutShort = all.isCutShort || report.isCutShort;
    all.isRefused = all.isRefused || report.isRefused;
  }
  return all;
}

}  // namespace handlebody
