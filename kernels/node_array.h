// Host storage of a tree's nodes: 64-byte aligned, so that a pair of siblings is one cache line.
#pragma once

#include <new>
#include <vector>

#include "bvh.h"

namespace ctpbench {

template <class T>
struct CacheLineAllocator {
    using value_type = T;
    CacheLineAllocator() = default;
    template <class U>
    CacheLineAllocator(const CacheLineAllocator<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64}));
    }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
    bool operator==(const CacheLineAllocator&) const { return true; }
};

using NodeArray = std::vector<BvhNode, CacheLineAllocator<BvhNode>>;

}  // namespace ctpbench
