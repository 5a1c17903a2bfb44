// The paper's variant (Sec. 3): a recursive union, a tag, and a visitor that unfolds the type list into
// a chain of comparisons, so that every call is bound early and can be inlined.
//
// Visit by reference. The paper's library copied the variant for every primitive test; on a GPU that
// copy alone costs local memory in the innermost loop.
#pragma once

#include <cstdint>

#include "type_list.h"

namespace ctpbench {

template <class... Ts>
union VariantStorage {};

template <class T, class... Ts>
union VariantStorage<T, Ts...> {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);
    T element;
    VariantStorage<Ts...> next;

    template <class U>
    CTP_INLINE void set(const U& value) {
        if constexpr (std::is_same_v<T, U>)
            element = value;
        else
            next.set(value);
    }
};

template <class... Ts>
struct Variant {
    using Types = TypeList<Ts...>;

    VariantStorage<Ts...> storage;
    std::uint32_t tag;

    Variant() = default;
    template <class T>
    CTP_INLINE explicit Variant(const T& value) : tag(index_of<T, Types>) {
        storage.set(value);
    }
};

namespace detail {
template <std::uint32_t position, class... Ts>
CTP_INLINE const auto& element_at(const VariantStorage<Ts...>& storage) {
    if constexpr (position == 0)
        return storage.element;
    else
        return element_at<position - 1>(storage.next);
}

// Comparisons side by side, as in visit_type().
template <class Visitor, class... Ts, std::uint32_t... tags>
CTP_INLINE auto visit_storage(Visitor& visitor, const VariantStorage<Ts...>& storage, std::uint32_t tag,
                              std::integer_sequence<std::uint32_t, tags...>) {
    using Result = decltype(visitor(element_at<0>(storage)));
    if constexpr (std::is_void_v<Result>) {
        const bool found = ((tag == tags && (visitor(element_at<tags>(storage)), true)) || ...);
        if (!found) trap();
    } else {
        Result result;
        const bool found = ((tag == tags && (result = visitor(element_at<tags>(storage)), true)) || ...);
        if (!found) trap();
        return result;
    }
}
}  // namespace detail

// Calls the visitor with the element that the variant holds. A tag outside the list traps.
template <class Visitor, class... Ts>
CTP_INLINE auto apply_visitor(Visitor&& visitor, const Variant<Ts...>& variant) {
    return detail::visit_storage(visitor, variant.storage, variant.tag,
                                 std::make_integer_sequence<std::uint32_t, sizeof...(Ts)>{});
}

}  // namespace ctpbench
