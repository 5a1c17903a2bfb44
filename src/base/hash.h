// XXH3 of plain memory: for telling inputs, trees and hit records apart, not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ctpbench {

// Sixteen hexadecimal digits.
std::string hex(std::uint64_t value);

std::uint64_t hash_bytes(const void* data, std::size_t bytes, std::uint64_t seed = 0);

template <class T, class Allocator>
std::uint64_t hash_vector(const std::vector<T, Allocator>& values, std::uint64_t seed = 0) {
    return hash_bytes(values.data(), values.size() * sizeof(T), seed);
}

}  // namespace ctpbench
