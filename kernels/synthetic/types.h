// Lists of synthetic types: as many types of like cost as a study asks for, to see how each strategy's cost
// grows with the length of its list.
#pragma once

#include <cstdint>
#include <iterator>

#include "../type_list.h"

namespace ctpbench {

// Which list a contender is compiled for.
struct SyntheticTypes {
    std::uint32_t listed = 0;  // how many types; 0: the scene's own types instead
    bool large = false;        // whether the first of them is large

    CTP_INLINE bool any() const { return listed != 0; }
    bool operator==(const SyntheticTypes&) const = default;
};

// The lists that there are.
inline constexpr std::uint32_t kSyntheticLists[] = {1, 2, 4, 8, 16, 32, 64};
inline constexpr std::uint32_t kLargeSyntheticLists[] = {2,
                                                         8};  // those of which there is one with a large type
inline constexpr std::uint32_t kDeviceSyntheticLists[] = {1, 8,
                                                          32};  // those of which there is one on a device
// Those of the first that this build has on the host: long ones take sanitizers minutes to compile.
#if defined(CTPBENCH_FEW_TYPES)
inline constexpr std::uint32_t kBuiltLists[] = {1, 2, 8};
#else
inline constexpr const auto& kBuiltLists = kSyntheticLists;
#endif
inline constexpr std::uint32_t kMaxSyntheticTypes = 64;
inline constexpr std::uint32_t kLargeBytes = 256;  // that a large type is larger than the others

// A power of two for each type. Types store their numbers in units of their own, which is what makes them of
// like cost and yet no compiler can take one for another; scaling by powers of two is exact.
template <int number>
inline constexpr float synthetic_unit = number < 32 ? 1.0f / static_cast<float>(1ull << (32 - number))
                                                    : static_cast<float>(1ull << (number - 31));

namespace detail {
template <template <int, bool> class T, bool large, class Numbers>
struct SyntheticList;
template <template <int, bool> class T, bool large, int... numbers>
struct SyntheticList<T, large, std::integer_sequence<int, numbers...>> {
    using type = TypeList<T<numbers, large && numbers == 0>...>;
};
}  // namespace detail

// T<0, large>, T<1, false>, ..., T<listed - 1, false>
template <template <int, bool> class T, int listed, bool large>
using SyntheticList = typename detail::SyntheticList<T, large, std::make_integer_sequence<int, listed>>::type;

// Calls f(TypeTag<SyntheticList<T, ...>>{}) with the list of these types, on the host or a device. One that
// there is not traps.
template <template <int, bool> class T, bool device = false, class F>
void visit_synthetic(const SyntheticTypes& types, F&& f) {
    bool found = false;
    const auto look = [&](auto listed, auto large) {
        if (types != SyntheticTypes{listed.value, large.value}) return;
        found = true;
        f(TypeTag<SyntheticList<T, listed.value, large.value>>{});
    };
    if constexpr (device) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (look(std::integral_constant<std::uint32_t, kDeviceSyntheticLists[i]>{}, std::false_type{}), ...);
        }
        (std::make_index_sequence<std::size(kDeviceSyntheticLists)>{});
    } else {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (look(std::integral_constant<std::uint32_t, kBuiltLists[i]>{}, std::false_type{}), ...);
        }
        (std::make_index_sequence<std::size(kBuiltLists)>{});
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (look(std::integral_constant<std::uint32_t, kLargeSyntheticLists[i]>{}, std::true_type{}), ...);
        }
        (std::make_index_sequence<std::size(kLargeSyntheticLists)>{});
    }
    if (!found) trap();
}

// What the large ones carry along.
template <bool large>
struct Ballast {};
template <>
struct Ballast<true> {
    std::uint32_t words[kLargeBytes / 4];
};

}  // namespace ctpbench
