#pragma once
// Internal: the files that a session names beside its volume, wherever in it they stand.

#include "core/io/report/session.h"

namespace handlebody {

//! f(map) of the label maps of walls at the beginning of a growth and in changes on the way.
template <typename AnyConstraints, typename Changes, typename F>
void forEachWallMap(AnyConstraints& first, Changes& changes, F&& f) {
  if (first.walls.map) f(*first.walls.map);
  for (auto& change : changes)
    if (change.constraints && change.constraints->walls.map) f(*change.constraints->walls.map);
}

//! The same of a session, in its corrected frames, too.
template <typename AnySession, typename F>
void forEachWallMap(AnySession& session, F&& f) {
  forEachWallMap(session.constraints, session.changes, f);
  if (!session.overTime) return;
  for (auto& c : session.overTime->corrections) forEachWallMap(c.request.constraints, c.changes, f);
}

//! f(start) of the surfaces to begin with, at the beginning and in changes on the way.
template <typename AnySession, typename F>
void forEachStart(AnySession& session, F&& f) {
  if (session.constraints.start) f(*session.constraints.start);
  for (auto& change : session.changes)
    if (change.constraints && change.constraints->start) f(*change.constraints->start);
}

}  // namespace handlebody
