#include "core/evolution/parameter_limits.h"

#include <algorithm>

#include "core/indices.h"

namespace handlebody {

ParameterLimits limitsFor(const Grid& grid) {
  double longest = 0;
  for (int a = 0; a < 3; ++a) longest = std::max(longest, grid.size[idx(a)] * grid.spacing[a]);
  return {longest, longest / 4, longest / 2};
}

}  // namespace handlebody
