#pragma once
// The handle database (paper, section 3): generators of the handles for small caps, stored, and expanded by
// rotations and exchanges.
//
// The text (resources/handles/handles.txt) has a line for each family and sizes, with the number of handles
// and of generators, and a line for each generator: the apexes of the faces on the boundary edges 0, 1, …,
// then the Type 2 faces. Its last line is a checksum of all before it. It is made by make_handles and built
// into the library. Where it lists all handles of two loops it is what chooses one for a mesh
// (listed_handles.h); ShortestHandles searches all handles for loops of any sizes.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/handles/handle_enumeration.h"

namespace handlebody {

struct StoredHandles {
  Family family = Family::balanced;
  std::vector<int> sizes;  //!< ascending (the paper's m_1 <= m_2 <= …)
  std::uint64_t handles = 0;
  std::vector<Handle> generators;  //!< the least handle of each orbit
};

class HandleDatabase {
 public:
  //! What is built into the library; read at the first call. Thread-safe.
  static const HandleDatabase& stored();

  //! Reads the text. Throws InputError if it is damaged (checksum) or not a handle database.
  explicit HandleDatabase(std::string_view text);

  const std::vector<StoredHandles>& entries() const { return entries_; }
  //! Null if these sizes (in any order) are not stored for the family.
  const StoredHandles* find(std::span<const int> sizes, Family family) const;

 private:
  std::vector<StoredHandles> entries_;  // sorted by family and sizes
};

//! All handles of an entry, in lexicographic order: the orbits of its generators.
std::vector<Handle> expand(const StoredHandles& entry);

//! The text, made anew by listing all handles of the stored sizes: balanced for three and four caps, monotone
//! and all for two, all for the smallest three. Takes seconds.
std::string makeHandleDatabase();

//! As it is built in.
std::string_view handleDatabaseText();

//! "balanced", "monotone" or "all".
const char* familyName(Family family);

}  // namespace handlebody
