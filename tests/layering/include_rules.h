#pragma once
// Who may include whom. Works on source text, so that a test can hand it a tree that breaks the rules.

#include <map>
#include <string>
#include <vector>

namespace handlebody::test {

//! Path from the top of the project ("core/mesh/mesh.h") → the file's text.
using SourceTree = std::map<std::string, std::string>;

//! The C++ files under core, ui, app, python and sample_volumes of the project at `root`.
SourceTree readSources(const std::string& root);

//! One sentence, "FILE:LINE: …", for every include that breaks a rule, in the order of the files:
//! - geometry ← mesh ← collision, handles ← surgery ← evolution; geometry ← volume ← evolution; collision,
//!   object ← solid ← evolution; io on all of core;
//!   sample_volumes and ui on core and io; python on these but ui; model ← view ← window within ui; app on
//!   everything; nothing on tests.
//! - core outside io: Eigen and the standard library only.
//! - Qt nowhere in core. ITK, GDCM and VTK in core only under io; a header of io that reaches them, itself or
//!   through another, is for io alone.
//! - Project files are named by their path from the top, so that the rules can see them.
std::vector<std::string> brokenRules(const SourceTree& sources);

}  // namespace handlebody::test
