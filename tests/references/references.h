#pragma once
// What a page for developers names in its code spans and links, and whether it is there.

#include <map>
#include <set>
#include <string>
#include <vector>

namespace handlebody::test {

//! The project as pages may name it.
struct Project {
  std::set<std::string> paths;  //!< of files and folders, from the top: "core/mesh/mesh.h", "core/mesh"
  std::map<std::string, std::set<std::string>> tests;  //!< path of a test's source → names of its tests
  std::set<std::string> words;  //!< of sources, scripts and build files: identifiers and options
  std::map<std::string, std::set<std::string>> wordsOf;     //!< path without ending → words of .h and .cpp
  std::map<std::string, std::vector<std::string>> linesOf;  //!< path of a source → its lines
};

//! The project at `root`: all that is not hidden, but build folders.
Project readProject(const std::string& root);

//! One sentence, "PAGE:LINE: …", for each reference of the page (Markdown) that names nothing:
//! - `core/mesh/mesh.h`, `core/mesh`, `core/mesh/mesh` (for .h and .cpp): a path from the top;
//! - `"a sentence"`: a test, of the source that was named last before it on the same line, or else of any;
//! - `name`, `Type::name`, `name()`, `--option`: identifiers and options, which occur somewhere; in a list
//! behind
//!   a source and a colon (`core/mesh/mesh.h`: `Mesh`, `Mesh::next`) in that header or its source;
//! - `core/mesh/mesh.h:12` `Mesh`: a line of a source, and the name that stands on it;
//! - [text](path): a file, from the page's folder; links to the web are not followed.
//! Other code spans (commands, formulas, text with spaces) are left alone. Blocks of code are, too.
std::vector<std::string> brokenReferences(const Project& project, const std::string& page,
                                          const std::string& text);

}  // namespace handlebody::test
