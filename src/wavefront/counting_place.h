// The place of what is not there yet: it allocates nothing and counts what a device would have to hold.
// Whatever is laid out through a place says how much memory it takes by the very code that will allocate it.
//
// Beside what a HostPlace does, a device's place and this one
//   reserve<T>(n)            memory that stays, not initialised
//   lend(array, n)           a copy that goes with the holder; one at a time
//   launch(n, kernel, name)  runs a kernel on what is there
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "kernels/array.h"
#include "kernels/slot.h"

namespace ctpbench {

// Of one place: what stays, and the most that is lent beside it.
class PlaceBytes {
public:
    void keep(std::size_t bytes) { kept_ += bytes; }
    void lend(std::size_t bytes) { lent_ = std::max(lent_, bytes); }
    std::size_t kept() const { return kept_; }
    std::size_t total() const { return kept_ + lent_; }

private:
    std::size_t kept_ = 0, lent_ = 0;
};

class CountingPlace {
public:
    template <class E>
    using Element = Slot<E>;

    template <class T>
    struct Lent {
        const T* pointer;
        const T* data() const { return pointer; }
    };

    template <class T>
    const T* operator()(const T*, std::size_t n) const {
        return reserve<T>(n);
    }
    template <class T>
    const Slot<T>* elements(const Array<T>& array) const {
        return reserve<Slot<T>>(array.size());
    }
    template <class T>
    T* reserve(std::size_t n) const {
        T* p = address<T>();
        bytes_.keep(n * sizeof(T));
        return p;
    }
    template <class T>
    Lent<T> lend(const T*, std::size_t n) const {
        bytes_.lend(n * sizeof(T));
        return {address<T>()};
    }
    template <class Kernel>
    void launch(std::uint32_t, const Kernel&, const char*) const {}

    std::size_t bytes() const { return bytes_.total(); }

private:
    // Not null, so that sums with it are in order; nobody may follow it.
    template <class T>
    T* address() const {
        return reinterpret_cast<T*>(std::uintptr_t{4096} + bytes_.kept() / 64 * 64);
    }

    mutable PlaceBytes bytes_;
};

}  // namespace ctpbench
