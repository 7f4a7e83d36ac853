#pragma once
// Internal: exceptions of the libraries below as ours. No type of a library appears here.

#include <functional>
#include <string>

namespace handlebody {

//! Runs f; exceptions of ITK, GDCM and the standard library become InputErrors ("path: what (description).").
void withItk(const std::string& path, const std::string& what, const std::function<void()>& f);

}  // namespace handlebody
