#include <gtest/gtest.h>

#include <limits>

#include "accel/sbvh.h"
#include "base/error.h"

namespace ctpbench::test {
namespace {

TEST(SbvhSettings, PresetsAreValid) {
    EXPECT_NO_THROW(SbvhSettings::paper().validate());
    EXPECT_NO_THROW(SbvhSettings::quality().validate());
}

template <class T>
void expect_rejected(T SbvhSettings::*field, T value, const char* name) {
    SbvhSettings settings;
    settings.*field = value;
    try {
        settings.validate();
        ADD_FAILURE() << name << " = " << value << " was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
}

TEST(SbvhSettings, ValuesOutOfRangeAreNamed) {
    expect_rejected(&SbvhSettings::object_bins, 1u, "object_bins");
    expect_rejected(&SbvhSettings::spatial_bins, 1000u, "spatial_bins");
    expect_rejected(&SbvhSettings::sweep_below, 65u, "sweep_below");
    expect_rejected(&SbvhSettings::max_leaf, 0u, "max_leaf");
    expect_rejected(&SbvhSettings::node_cost, 0.0f, "node_cost");
    expect_rejected(&SbvhSettings::primitive_cost, -1.0f, "primitive_cost");
    expect_rejected(&SbvhSettings::alpha, std::numeric_limits<float>::quiet_NaN(), "alpha");
    expect_rejected(&SbvhSettings::reference_budget, 0.5f, "reference_budget");
}

}  // namespace
}  // namespace ctpbench::test
