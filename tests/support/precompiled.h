#pragma once
// As core/geometry/precompiled.h, for tests.

#include "core/geometry/precompiled.h"
#include "tests/support/catch.h"
