// The kinds of leaves that strategies have in the 8-wide tree, and who uses which.
#pragma once

#include <variant>

#include "../dispatch/layout.h"
#include "leaves.h"

namespace ctpbench {

struct VisitVariant {
    template <class Visitor, class Sum>
    CTP_INLINE auto operator()(Visitor&& visitor, const Sum& sum) const {
        return apply_visitor(visitor, sum);
    }
};
struct VisitStdVariant {
    template <class Visitor, class Sum>
    CTP_INLINE auto operator()(Visitor&& visitor, const Sum& sum) const {
        return std::visit(visitor, sum);
    }
};

// Of one type all sums are the same: the type itself.
template <class Types, template <class...> class Sum, class Visit>
using SumBlocks = std::conditional_t<Types::size == 1, TypedBlocks<BlocksOf<Types>, true>,
                                     SumTypeBlocks<BlocksOf<Types>, OneOf<Sum, BlocksOf<Types>>, Visit>>;

// The kinds of leaves that there are. By their position they are told apart where types are not known.
enum class LeafKind : std::uint32_t { typed_phases, typed, variant, std_variant, objects };
template <class Types>
using LeafKinds = TypeList<TypedBlocks<BlocksOf<Types>, true>, TypedBlocks<BlocksOf<Types>, Types::size == 1>,
                           SumBlocks<Types, Variant, VisitVariant>,
                           SumBlocks<Types, std::variant, VisitStdVariant>, VirtualBlocks<BlocksOf<Types>>>;

// Who has them: the strategies of single rays, with blocks for primitives, and one that needs many rays.
struct WideCtp {
    static constexpr const char* name = "ctp";
    static constexpr TreeKind tree = TreeKind::mixed;
    static constexpr LeafKind leaves = LeafKind::variant;
};
struct WideStdVariant {
    static constexpr const char* name = "std_variant";
    static constexpr TreeKind tree = TreeKind::mixed;
    static constexpr LeafKind leaves = LeafKind::std_variant;
};
// Objects are allocated one by one.
struct WideOop {
    static constexpr const char* name = "oop";
    static constexpr TreeKind tree = TreeKind::mixed;
    static constexpr LeafKind leaves = LeafKind::objects;
};
// Objects lie together, in the order of leaves.
struct WideOopArena {
    static constexpr const char* name = "oop_arena";
    static constexpr TreeKind tree = TreeKind::mixed;
    static constexpr LeafKind leaves = LeafKind::objects;
};
// A tree and a pass for each type.
struct WideRestart {
    static constexpr const char* name = "restart";
    static constexpr TreeKind tree = TreeKind::per_type;
    static constexpr LeafKind leaves = LeafKind::typed_phases;
};
struct WideTypedLeaves {
    static constexpr const char* name = "typed_leaves";
    static constexpr TreeKind tree = TreeKind::typed_leaves;
    static constexpr LeafKind leaves = LeafKind::typed;
};
// Rays that are at leaves of one type are worked off together: no branch on type but that between the loops.
struct WideTypedPhases {
    static constexpr const char* name = "typed_phases";
    static constexpr TreeKind tree = TreeKind::typed_leaves;
    static constexpr LeafKind leaves = LeafKind::typed_phases;
};
using InterleavedStrategies =
    TypeList<WideCtp, WideStdVariant, WideOop, WideOopArena, WideRestart, WideTypedLeaves, WideTypedPhases>;

}  // namespace ctpbench
