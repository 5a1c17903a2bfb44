// The tables of a study of convergence.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

// convergence.csv: a line per contender and power of two. Seconds are medians over seeds with a bootstrap
// interval, relMSE is a mean over seeds with Student's, rmse is the root of the mean where it is positive.
std::string convergence_csv(const Config& config, const Results& results);

// convergence_fits.csv: a line per contender. The slope is that of log rmse against log samples, bias_relmse
// the height at which the curve ends. Contenders that were rejected are in neither table.
std::string convergence_fits_csv(const Config& config, const Results& results);

}  // namespace ctpbench
