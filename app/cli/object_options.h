#pragma once
// How the object is called in what is written of it.

#include <optional>
#include <string>

#include "core/io/meshes/exported_object.h"

namespace CLI {
class App;
}

namespace handlebody::cli {

//! As given; what is not comes from the session, or from the term.
struct ObjectOptions {
  std::optional<std::string> name, term;
  std::optional<Colour> colour;
  std::optional<int> value;
};

//! Adds --object-name, --color, --label-value and --term.
void addObjectOptions(CLI::App& command, ObjectOptions& options);

//! `before` with what the options change. A term goes before the codes of a file, and brings its colour, and
//! its meaning as the name of an object that has none of its own.
ObjectLabel chosenLabel(const ObjectOptions& options, const ObjectLabel& before);

}  // namespace handlebody::cli
