// A list of types as a type, and the few compile-time operations on it that the suite needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "platform.h"

namespace ctpbench {

template <class... Ts>
struct TypeList {
    static constexpr std::size_t size = sizeof...(Ts);
};

namespace detail {
template <class T, class List>
struct IndexOf;
template <class T, class... Ts>
struct IndexOf<T, TypeList<T, Ts...>> : std::integral_constant<int, 0> {};
template <class T, class U, class... Ts>
struct IndexOf<T, TypeList<U, Ts...>> : std::integral_constant<int, 1 + IndexOf<T, TypeList<Ts...>>::value> {
};

template <template <class...> class To, class List>
struct Rebind;
template <template <class...> class To, class... Ts>
struct Rebind<To, TypeList<Ts...>> {
    using type = To<Ts...>;
};
}  // namespace detail

// Position of T in the list; a type that is not in it does not compile.
template <class T, class List>
inline constexpr int index_of = detail::IndexOf<T, List>::value;

// To<Ts...> for a TypeList<Ts...>.
template <template <class...> class To, class List>
using Rebind = typename detail::Rebind<To, List>::type;

template <class T>
struct TypeTag {
    using type = T;
};

// Calls f(TypeTag<T>{}) for each T, in order. On either side: f may belong to one only.
#if defined(__CUDACC__)
#pragma nv_exec_check_disable
#endif
template <class... Ts, class F>
CTP_HD constexpr void for_each_type(TypeList<Ts...>, F&& f) {
    (f(TypeTag<Ts>{}), ...);
}

namespace detail {
template <std::uint32_t Tag, class F>
CTP_INLINE void visit_type(TypeList<>, std::uint32_t, F&&) {
    trap();
}
template <std::uint32_t Tag, class T, class... Ts, class F>
CTP_INLINE void visit_type(TypeList<T, Ts...>, std::uint32_t tag, F&& f) {
    if (tag == Tag)
        f(TypeTag<T>{});
    else
        visit_type<Tag + 1>(TypeList<Ts...>{}, tag, f);
}
}  // namespace detail

// Calls f(TypeTag<T>{}) for the T at position `tag`. A tag outside the list traps.
template <class List, class F>
CTP_INLINE void visit_type(std::uint32_t tag, F&& f) {
    detail::visit_type<0>(List{}, tag, f);
}

}  // namespace ctpbench
