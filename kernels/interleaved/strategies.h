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

// Who has them: the strategies of single rays, with blocks for primitives, and one that needs many rays:
// typed_phases works off together what is at leaves of one type, with no branch on type but that between
// loops.
struct InterleavedStrategy {
    const char* name;
    TreeKind tree;
    LeafKind leaves;
    bool objects_together = false;  // in the order of leaves; else each is allocated by itself
};
inline constexpr InterleavedStrategy kInterleavedStrategies[] = {
    {"ctp", TreeKind::mixed, LeafKind::variant},
    {"std_variant", TreeKind::mixed, LeafKind::std_variant},
    {"oop", TreeKind::mixed, LeafKind::objects},
    {"oop_arena", TreeKind::mixed, LeafKind::objects, true},
    {"restart", TreeKind::per_type, LeafKind::typed_phases},
    {"typed_leaves", TreeKind::typed_leaves, LeafKind::typed},
    {"typed_phases", TreeKind::typed_leaves, LeafKind::typed_phases},
};

}  // namespace ctpbench
