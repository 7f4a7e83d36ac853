#pragma once
// What `compare` found in JSON. Only sources include this header, as json.h.

#include "core/io/report/compared.h"
#include "core/io/report/json.h"

namespace handlebody {

//! comparisonJson before it is text.
Json comparisonToJson(const ComparedPair& pair);

}  // namespace handlebody
