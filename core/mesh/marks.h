#pragma once
// Yes or no for each element of a mesh, by its slot: 0 is no. Bytes, since a vector<bool> has no span and
// cannot be written by several threads.

#include <span>
#include <vector>

namespace handlebody {

using VertexMarks = std::vector<unsigned char>;
using FaceMarks = std::vector<unsigned char>;
using ComponentMarks = std::vector<unsigned char>;
using VertexMarkSpan = std::span<const unsigned char>;
using FaceMarkSpan = std::span<const unsigned char>;

}  // namespace handlebody
