// A list of types as a type, and the few compile-time operations on it that the suite needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

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

template <class List, class T>
struct Append;
template <class... Ts, class T>
struct Append<TypeList<Ts...>, T> {
    using type = TypeList<Ts..., T>;
};

template <class Kept, std::uint32_t mask, class List>
struct Filter {
    using type = Kept;
};
template <class Kept, std::uint32_t mask, class T, class... Ts>
struct Filter<Kept, mask, TypeList<T, Ts...>> {
    using Grown = typename Append<Kept, T>::type;
    using type = typename Filter<std::conditional_t<(mask & 1u) != 0, Grown, Kept>, (mask >> 1),
                                 TypeList<Ts...>>::type;
};

template <class List>
struct First;
template <class T, class... Ts>
struct First<TypeList<T, Ts...>> {
    using type = T;
};
}  // namespace detail

// Position of T in the list; a type that is not in it does not compile.
template <class T, class List>
inline constexpr int index_of = detail::IndexOf<T, List>::value;

// To<Ts...> for a TypeList<Ts...>.
template <template <class...> class To, class List>
using Rebind = typename detail::Rebind<To, List>::type;

// The types at those positions of the list whose bit in the mask is set, in the order of the list.
template <class List, std::uint32_t mask>
using Filtered = typename detail::Filter<TypeList<>, mask, List>::type;

// All bits that a mask over the list can have.
template <class List>
inline constexpr std::uint32_t whole_mask = (1u << List::size) - 1;

template <class List>
using First = typename detail::First<List>::type;

// To<Ts...>, or the type itself where there is but one: that needs no tag, no branch and no padding.
template <template <class...> class To, class List>
using OneOf =
    typename std::conditional_t<List::size == 1, detail::First<List>, detail::Rebind<To, List>>::type;

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
template <class T, class Member>
struct PerTypeEntry {
    Member member{};
};
template <template <class> class Member, class List>
struct PerTypeOf;
template <template <class> class Member, class... Ts>
struct PerTypeOf<Member, TypeList<Ts...>> : PerTypeEntry<Ts, Member<Ts>>... {};
}  // namespace detail

// A Member<T> for each T of the list. Cheaper to compile than a tuple: lists can be long.
template <template <class> class Member, class List>
struct PerType {
    detail::PerTypeOf<Member, List> all;

    template <class T>
    CTP_INLINE const Member<T>& of() const {
        return static_cast<const detail::PerTypeEntry<T, Member<T>>&>(all).member;
    }
    template <class T>
    CTP_INLINE Member<T>& of() {
        return static_cast<detail::PerTypeEntry<T, Member<T>>&>(all).member;
    }
};

namespace detail {
// Comparisons side by side rather than one function in another: inlining a long nest takes a compiler
// minutes.
template <class... Ts, class F, std::uint32_t... tags>
CTP_INLINE void visit_type(TypeList<Ts...>, std::uint32_t tag, F& f,
                           std::integer_sequence<std::uint32_t, tags...>) {
    const bool found = ((tag == tags && (f(TypeTag<Ts>{}), true)) || ...);
    if (!found) trap();
}
}  // namespace detail

// Calls f(TypeTag<T>{}) for the T at position `tag`. A tag outside the list traps.
template <class List, class F>
CTP_INLINE void visit_type(std::uint32_t tag, F&& f) {
    detail::visit_type(List{}, tag, f, std::make_integer_sequence<std::uint32_t, List::size>{});
}

namespace detail {
template <class List, class F, std::uint32_t... masks>
void visit_filtered(std::uint32_t mask, F& f, std::integer_sequence<std::uint32_t, masks...>) {
    using Call = void (*)(F&);
    static constexpr Call table[] = {[](F& call) { call(TypeTag<Filtered<List, masks + 1>>{}); }...};
    if (mask == 0 || mask > sizeof...(masks)) trap();
    table[mask - 1](f);
}
}  // namespace detail

// Calls f(TypeTag<Filtered<List, mask>>{}) for a mask that only shows at run time: the lists are instantiated
// for every mask, and a table picks one. A mask of nothing, or of more than the list has, traps.
template <class List, class F>
void visit_filtered(std::uint32_t mask, F&& f) {
    detail::visit_filtered<List>(mask, f, std::make_integer_sequence<std::uint32_t, whole_mask<List>>{});
}

}  // namespace ctpbench
