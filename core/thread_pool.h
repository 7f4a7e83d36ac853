#pragma once
// The threads that help with work in pieces (threads.h).

#include <cstddef>

namespace handlebody {

//! Work in `pieces` pieces that may be done at the same time, on up to `threads` threads.
struct PooledWork {
  std::size_t pieces;
  int threads;
  void* context;
  void (*call)(void* context, std::size_t piece);
};

//! Calls work.call(work.context, i) once for each piece i, on this thread and on others that have nothing
//! else to do. Returns when all that was begun has ended; throws what a piece has thrown, and then begins no
//! other. May be called by any number of threads, and from within a piece. Threads are made when they are
//! first asked for, and kept, as memory is: to make one anew takes as long as a piece of a step does.
void runOnPool(const PooledWork& work);

}  // namespace handlebody
