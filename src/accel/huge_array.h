// Memory for a build: as it comes, in huge pages where the system grants them, since the first touch of small
// ones can take a fifth of a build.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "kernels/array.h"

namespace ctpbench {

template <class T>
class HugeArray {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    // Pages that are not written to are never committed.
    explicit HugeArray(std::size_t size)
        : size_(size), data_(size > 0 ? TraversalAllocator<T>().allocate(size) : nullptr) {}
    HugeArray(HugeArray&& other) noexcept
        : size_(std::exchange(other.size_, 0)), data_(std::exchange(other.data_, nullptr)) {}
    HugeArray& operator=(HugeArray&& other) noexcept {
        std::swap(size_, other.size_);
        std::swap(data_, other.data_);
        return *this;
    }
    ~HugeArray() { reset(); }

    std::size_t size() const { return size_; }
    T* get() const { return data_; }
    T& operator[](std::size_t i) const { return data_[i]; }
    void reset() {
        if (data_ != nullptr) TraversalAllocator<T>().deallocate(data_, size_);
        data_ = nullptr;
        size_ = 0;
    }

private:
    std::size_t size_;
    T* data_;
};

}  // namespace ctpbench
