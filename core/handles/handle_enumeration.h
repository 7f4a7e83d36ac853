#pragma once
// Lists and counts the handles of the paper's section 3 for caps of given sizes.
//
// The vertices of the caps are numbered one cap after the other, from 0; cap i has the boundary vertices
// first(i) … first(i) + sizes[i] - 1 in the order in which handle faces hold its boundary edges (the reverse
// of the order in the cap itself, so that its inclusion keeps orientation). Handle faces are those of the
// paper: m of Type 1 (a boundary edge and a vertex of another cap) and 2k - 4 of Type 2 (three caps).

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace handlebody {

//! Faces of a handle; each starts with its least vertex, and they are sorted.
using Handle = std::vector<Triangle>;

enum class Family {
  //! Every boundary vertex is the apex of exactly one face of Type 1 and lies in at most one of Type 2: what
  //! Table 1 of the paper counts.
  balanced,
  //! k = 2: every vertex of the smaller cap is the apex of a face of Type 1, as for the monotone surjective
  //! maps of Example 8 and their rotations.
  monotone,
  //! All handles of Definition 5 with faces of Types 1 and 2.
  all,
};

struct HandleCount {
  std::uint64_t handles = 0;
  //! Orbits under rotations of each cap and exchanges of caps of equal size; both keep the orientation.
  std::uint64_t generators = 0;
};

//! More handles than this are not listed.
constexpr std::size_t kMaxListedHandles = 200'000;

//! Every handle once, in lexicographic order. Exhaustive search: meant for small sizes. Throws UsageError as
//! countHandles does, and if there are more than kMaxListedHandles or the search takes too long.
std::vector<Handle> enumerateHandles(std::span<const int> sizes, Family family);

//! Calls visit for every handle once, in no order, faces as they were found: for more handles than can be
//! kept. None has an edge of `forbidden` (in either direction). Throws UsageError as countHandles does, and
//! if the search takes too long.
void forEachHandle(std::span<const int> sizes, Family family, const std::function<void(const Handle&)>& visit,
                   std::span<const std::array<int, 2>> forbidden = {});

//! How many orbits the handles form under rotations and exchanges. Precondition: `handles` is what
//! enumerateHandles(sizes, …) returned.
std::uint64_t countGenerators(std::span<const int> sizes, std::span<const Handle> handles);

//! The least handle of each orbit, in their order. Precondition as for countGenerators.
std::vector<Handle> generatorsOf(std::span<const int> sizes, std::span<const Handle> handles);

//! All handles that rotations and exchanges make of one, in lexicographic order.
std::vector<Handle> orbitOf(std::span<const int> sizes, const Handle& generator);

//! The exact numbers. Closed formulas for k = 2 and for balanced handles of k = 3, any sizes; the rest is
//! looked up in the database, or listed. Throws UsageError for k other than 2, 3, 4 (monotone: other than 2),
//! a size below 3, numbers beyond 64 bits, and for handles that must be listed but are too many.
HandleCount countHandles(std::span<const int> sizes, Family family);

//! The faces of a handle and of the caps it closes; the centre of cap i gets the number m + i.
std::vector<Triangle> withCaps(std::span<const int> sizes, const Handle& handle);

}  // namespace handlebody
