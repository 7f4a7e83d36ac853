#pragma once
// Tunnels, components and edits for people: one line each.

#include <string>
#include <vector>

#include "core/mesh/pieces.h"
#include "core/mesh/validity.h"
#include "core/surgery/mesh_edits.h"

namespace handlebody::cli {

//! One line per component, each with its number, volume (ml), size and place (mm).
std::string piecesText(const std::vector<Piece>& pieces);
//! One line per tunnel, with the lengths of both loops and its place (mm).
std::string tunnelsText(const TunnelList& list);
//! "tunnel closed at x,y,z …", without a newline.
std::string editText(const Event& edit);
//! Volumes and topology before and after, without a newline.
std::string changeText(const Certificate& before, const Certificate& after);

}  // namespace handlebody::cli
