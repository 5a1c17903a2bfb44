// Host storage of what a traversal reads: cache-line aligned, so that a pair of sibling nodes is one line,
// and in huge pages where the system grants them, so that a walk over hundreds of megabytes does not also
// walk the page tables.
#pragma once

#include <new>
#include <vector>

#include "bvh.h"
#include "platform.h"

namespace ctpbench {

template <class T>
struct TraversalAllocator {
    using value_type = T;
    TraversalAllocator() = default;
    template <class U>
    TraversalAllocator(const TraversalAllocator<U>&) {}

    static constexpr std::align_val_t alignment(std::size_t bytes) {
        return std::align_val_t{bytes < kHugePage ? 64 : kHugePage};
    }
    T* allocate(std::size_t n) {
        const std::size_t bytes = n * sizeof(T);
        void* p = ::operator new(bytes, alignment(bytes));
        if (bytes >= kHugePage) advise_huge_pages(p, bytes);
        return static_cast<T*>(p);
    }
    void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n * sizeof(T))); }
    bool operator==(const TraversalAllocator&) const { return true; }
};

template <class T>
using Array = std::vector<T, TraversalAllocator<T>>;

using NodeArray = Array<BvhNode>;

}  // namespace ctpbench
