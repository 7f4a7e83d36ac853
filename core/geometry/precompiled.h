#pragma once
// What nearly every file reads: compiled once per target, which makes building about twice as fast.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/vec.h"
