#pragma once

namespace handlebody {

//! How the detection finds near vertices: in one sorted table (quicker), or by the paper's eight hash
//! functions. Both find the same (vertex_pairs.h).
enum class BroadPhase { sorted, hashing };

}  // namespace handlebody
