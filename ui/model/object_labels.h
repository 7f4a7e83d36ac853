#pragma once
// What objects are called: names, label values and colours such as no two of them have.

#include <QString>
#include <vector>

#include "core/io/meshes/exported_object.h"

namespace handlebody::ui {

//! A label such as none of `known` has; only when all colours are taken one of them comes again.
ObjectLabel freshLabel(const std::vector<ObjectLabel>& known);
//! The same with name and value of `wanted` where they are free; the name with a number behind it if only
//! that is.
ObjectLabel labelFor(const ObjectLabel& wanted, const std::vector<ObjectLabel>& known);
//! Why the object at `index` of `known` cannot be called so, as a sentence; empty: it can.
QString labelFault(std::size_t index, const ObjectLabel& label, const std::vector<ObjectLabel>& known);

}  // namespace handlebody::ui
