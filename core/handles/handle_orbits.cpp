// Handles under rotations of caps and exchanges of caps of equal size.

#include <algorithm>
#include <cassert>
#include <numeric>
#include <set>

#include "core/handles/handle_enumeration.h"
#include "core/handles/handle_sizes.h"

namespace handlebody {
namespace {

using Permutation = std::vector<int>;

//! Rotation of each cap by one, and exchange of each two caps of equal size: they generate the group.
std::vector<Permutation> groupGenerators(std::span<const int> sizes) {
  std::vector<int> first(sizes.size() + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), first.begin() + 1);
  Permutation identity(static_cast<std::size_t>(first.back()));
  std::iota(identity.begin(), identity.end(), 0);
  std::vector<Permutation> result;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Permutation rotation = identity;
    std::rotate(rotation.begin() + first[i], rotation.begin() + first[i] + 1,
                rotation.begin() + first[i + 1]);
    result.push_back(rotation);
    for (std::size_t j = i + 1; j < sizes.size(); ++j) {
      if (sizes[i] != sizes[j]) continue;
      Permutation exchange = identity;
      std::swap_ranges(exchange.begin() + first[i], exchange.begin() + first[i + 1],
                       exchange.begin() + first[j]);
      result.push_back(exchange);
    }
  }
  return result;
}

Handle image(const Handle& handle, const Permutation& permutation) {
  Handle result = handle;
  for (Triangle& face : result) {
    for (int& v : face) v = permutation[v];
  }
  return normalised(std::move(result));
}

}  // namespace

Handle normalised(Handle handle) {
  for (Triangle& face : handle) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(handle.begin(), handle.end());
  return handle;
}

std::uint64_t countGenerators(std::span<const int> sizes, std::span<const Handle> handles) {
  return generatorsOf(sizes, handles).size();
}

std::vector<Handle> generatorsOf(std::span<const int> sizes, std::span<const Handle> handles) {
  const std::vector<Permutation> group = groupGenerators(sizes);
  std::vector<bool> reached(handles.size(), false);
  std::vector<std::size_t> pending;
  std::vector<Handle> orbits;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (reached[i]) continue;
    orbits.push_back(handles[i]);
    reached[i] = true;
    pending.push_back(i);
    while (!pending.empty()) {
      const Handle& handle = handles[pending.back()];
      pending.pop_back();
      for (const Permutation& permutation : group) {
        const auto at = std::lower_bound(handles.begin(), handles.end(), image(handle, permutation));
        assert(at != handles.end());  // the families are closed under the group
        const auto index = static_cast<std::size_t>(at - handles.begin());
        if (reached[index]) continue;
        reached[index] = true;
        pending.push_back(index);
      }
    }
  }
  return orbits;
}

std::vector<Handle> orbitOf(std::span<const int> sizes, const Handle& generator) {
  const std::vector<Permutation> group = groupGenerators(sizes);
  std::set<Handle> orbit{normalised(generator)};
  std::vector<const Handle*> pending{&*orbit.begin()};
  while (!pending.empty()) {
    const Handle& handle = *pending.back();
    pending.pop_back();
    for (const Permutation& permutation : group) {
      const auto [at, fresh] = orbit.insert(image(handle, permutation));
      if (fresh) pending.push_back(&*at);
    }
  }
  return {orbit.begin(), orbit.end()};
}

std::vector<Triangle> withCaps(std::span<const int> sizes, const Handle& handle) {
  std::vector<Triangle> faces = handle;
  const int centres = std::accumulate(sizes.begin(), sizes.end(), 0);
  int first = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (int v = 0; v < sizes[i]; ++v) {
      faces.push_back({centres + static_cast<int>(i), first + (v + 1) % sizes[i], first + v});
    }
    first += sizes[i];
  }
  return faces;
}

}  // namespace handlebody
