// Virtual wrappers, generated from the list of primitives: what a class hierarchy's user gets, with the
// same arithmetic inside.
#pragma once

#include "primitives/list.h"

namespace ctpbench {

template <class Methods>
class PrimitiveBase {
public:
    virtual ~PrimitiveBase() = default;
    CTP_HD virtual void intersect(const RayContext<Methods>& ray, Hit& hit) const = 0;
};

template <class Methods, class T>
class PrimitiveObject final : public PrimitiveBase<Methods> {
public:
    CTP_HD explicit PrimitiveObject(const T& value) : value_(value) {}
    CTP_HD void intersect(const RayContext<Methods>& ray, Hit& hit) const override {
        value_.intersect(ray, hit);
    }

private:
    T value_;
};

}  // namespace ctpbench
