// Objects with virtual functions, constructed in a place by placement new: a virtual table belongs to the
// side on which an object was made, and it alone knows where in an object its base class lies.
#pragma once

#include <new>

#include "kernels/array.h"

namespace ctpbench {

template <class Object, class Value>
struct ConstructObjects {
    Object* objects;
    const Value* values;

    CTP_HD void operator()(std::uint32_t i) const { new (objects + i) Object(values[i]); }
};

template <class Object, class Place, class Value>
Object* objects_in(const Place& place, const Array<Value>& values) {
    const auto lent = place.lend(values.data(), values.size());
    Object* objects = place.template reserve<Object>(values.size());
    place.launch(static_cast<std::uint32_t>(values.size()),
                 ConstructObjects<Object, Value>{objects, lent.data()}, "constructing objects");
    return objects;
}

}  // namespace ctpbench
