#pragma once
// Several objects of one volume: each that is done is a wall for the next.

#include <vector>

#include "app/cli/run.h"

namespace handlebody::cli {

//! Throws UsageError if two objects have the same name or label value.
void requireDistinct(const std::vector<ObjectLabel>& objects);

//! Grows the objects in their order, each that is done a wall for the next. `first` has the volume and the
//! first object; the others' sessions have the same volume. Throws as runObjects.
std::vector<GrownObject> growObjects(LoadedSession first, std::vector<Session> others,
                                     const RunOutputs& outputs);

//! Grows the objects in their order and writes everything together: if one of them fails nothing is written.
//! `first` has the volume and the first object; the others' sessions have the same volume. Returns the exit
//! code, kMaxIterations if that is why one of them stopped. Throws as run; messages begin with the object's
//! name. std::runtime_error if two meshes had a point in common (nothing is written then).
int runObjects(LoadedSession first, std::vector<Session> others, const RunOutputs& outputs);

}  // namespace handlebody::cli
