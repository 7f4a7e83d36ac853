#pragma once
// Units that are told to people.

namespace handlebody {

inline constexpr double kMillilitre = 1000;  //!< mm³

}  // namespace handlebody
