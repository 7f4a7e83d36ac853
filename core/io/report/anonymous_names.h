#pragma once
// Names that files give away, for what is written without anything that may name the patient.

#include <string>
#include <vector>

#include "core/finding.h"
#include "core/io/report/session.h"

namespace handlebody {

//! What an object is called, and the file of the surface that it begins with; empty: none.
struct NamedObject {
  std::string name, file;
};

//! The names of the objects where the patient is not to be named: "Object N" in place of one that is the name
//! of the object's file, or begins with it ("DOE 3", "DOE (2)"), as the window names what it opens. N is the
//! place in the list, from 1 on, or the next number that no other has. All other names stay as they are.
std::vector<std::string> anonymousNames(const std::vector<NamedObject>& objects);

//! The same of the objects of sessions. Before anonymous(), which leaves out the files.
void hideFileNames(std::vector<Session>& objects);

//! What is said of a volume, without the names of files and series that it lists.
Finding unnamed(Finding warning);

}  // namespace handlebody
