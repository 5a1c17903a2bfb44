// How fast the error of an image falls: the exponent of a power law. Independent samples give -1/2 (of RMSE);
// a bias flattens it, correlated or heavy-tailed samples show too.
#pragma once

#include <vector>

#include "measure/bounded_value.h"

namespace ctpbench {

// Least squares of log RMSE against log samples. relmse[s][k] is the relMSE of seed s after 2^k samples, the
// same number of doublings of each, two points at least; RMSE is the root of the mean over seeds. The images
// of one seed contain each other, so scatter about the line says nothing: the interval is the jackknife's
// over seeds. NaN where a mean is not positive.
BoundedValue rmse_slope(const std::vector<std::vector<double>>& relmse);

}  // namespace ctpbench
