#pragma once

namespace handlebody {

//! What only saves work and decides nothing: a copy starts without it.
template <typename T>
struct Scratch : T {
  Scratch() = default;
  Scratch(const Scratch&) : T() {}
  Scratch& operator=(const Scratch&) = delete;
  using T::operator=;
};

}  // namespace handlebody
