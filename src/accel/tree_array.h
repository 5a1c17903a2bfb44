// Arrays of a tree, as large as they must be but not set to anything: whoever fills them in parallel is the
// first to touch them.
#pragma once

#include <new>
#include <vector>

#include "kernels/array.h"

namespace ctpbench {

template <class T>
struct UnsetAllocator : TraversalAllocator<T> {
    using value_type = T;
    UnsetAllocator() = default;
    template <class U>
    UnsetAllocator(const UnsetAllocator<U>&) {}

    template <class U>
    void construct(U* p) {
        ::new (static_cast<void*>(p)) U;
    }
};

template <class T>
using TreeArray = std::vector<T, UnsetAllocator<T>>;

}  // namespace ctpbench
