#pragma once
// What `compare` found in JSON. Only sources include this header, as json.h.

#include "core/io/compared.h"
#include "core/io/json.h"

namespace handlebody {

//! comparisonJson before it is text.
Json comparisonToJson(const ComparedPair& pair);

}  // namespace handlebody
