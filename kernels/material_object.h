// Virtual wrappers of the material types: what a class hierarchy's user gets, with the same arithmetic
// inside.
#pragma once

#include "materials/list.h"

namespace ctpbench {

class MaterialBase {
public:
    virtual ~MaterialBase() = default;
    CTP_HD virtual Scattering sample(const SurfacePoint& point, const PathRandom& random) const = 0;
};

template <class T>
class MaterialObject final : public MaterialBase {
public:
    CTP_HD explicit MaterialObject(const T& value) : value_(value) {}
    CTP_HD Scattering sample(const SurfacePoint& point, const PathRandom& random) const override {
        return value_.sample(point, random);
    }

private:
    T value_;
};

}  // namespace ctpbench
