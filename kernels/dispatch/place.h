// Where a layout is traversed: a place turns a host array into the pointer to use there, and says in what
// form an element lies there. A device's memory is a place of its own; this is the host's.
#pragma once

#include <cstddef>

#include "../array.h"

namespace ctpbench {

struct HostPlace {
    template <class E>
    using Element = E;

    template <class T>
    const T* operator()(const T* array, std::size_t) const {
        return array;
    }
    template <class T>
    const T* elements(const Array<T>& array) const {
        return array.data();
    }
};

}  // namespace ctpbench
