#include "core/sequence/cycle_check.h"

namespace handlebody {

namespace {

Drift compared(const FrameResult& there, const FrameResult& back, int from, double edgeLength) {
  Drift drift;
  if (there.isTrusted() && back.isTrusted()) drift = driftBetween(there.mesh, back.mesh, edgeLength);
  drift.from = from;
  drift.at = there.frame;
  return drift;
}

}  // namespace

std::vector<Drift> checkCycle(const FrameCarrier& carrier, const std::vector<FrameResult>& frames,
                              const FrameResult& start, DriftCheck check, double edgeLength,
                              const std::function<void(const FrameResult&)>& told) {
  std::vector<Drift> drifts;
  if (check == DriftCheck::none || frames.size() < 2) return drifts;
  const FrameResult &first = frames.front(), &last = frames.back();
  if (check == DriftCheck::wrap) {
    if (!first.isTrusted()) return drifts;  // there is nothing to compare with
    if (!last.isTrusted()) return {{last.frame, first.frame}};
    FrameResult beside = last;  // they lie beside each other in a cycle
    beside.shownIn = last.frame;
    beside.frame = first.frame - 1;
    const FrameResult back = carrier.carry(beside, first.frame);
    if (told) told(back);
    return {compared(first, back, last.frame, edgeLength)};
  }
  for (int end : {first.frame, last.frame}) {
    const int step = end < start.frame ? 1 : -1;
    const auto at = [&](int frame) -> const FrameResult& { return frames[frame - first.frame]; };
    while (end != start.frame && !at(end).isTrusted()) end += step;
    if (end == start.frame) continue;
    const FrameResult back = carryThrough(carrier, at(end), start.frame, told).back();
    drifts.push_back(compared(start, back, end, edgeLength));
  }
  return drifts;
}

}  // namespace handlebody
