#include "kernels/variant.h"

#include <gtest/gtest.h>

#include <string>

namespace ctpbench {
namespace {

struct A {
    int a;
};
struct B {
    double b;
};
struct C {
    char c;
};
using V = Variant<A, B, C>;

std::string name_of(const V& v) {
    struct Namer {
        std::string operator()(const A& a) const { return "A" + std::to_string(a.a); }
        std::string operator()(const B& b) const { return "B" + std::to_string(static_cast<int>(b.b)); }
        std::string operator()(const C& c) const { return std::string("C") + c.c; }
    };
    return apply_visitor(Namer{}, v);
}

TEST(Variant, VisitsTheElementItHolds) {
    EXPECT_EQ(name_of(V(A{7})), "A7");
    EXPECT_EQ(name_of(V(B{8.0})), "B8");
    EXPECT_EQ(name_of(V(C{'x'})), "Cx");
}

TEST(Variant, VisitsByReference) {
    const V v(B{1.0});
    const void* seen = nullptr;
    apply_visitor([&](const auto& element) { seen = &element; }, v);
    EXPECT_EQ(seen, static_cast<const void*>(&v));
}

TEST(Variant, IsAsLargeAsItsLargestElementAndATag) {
    EXPECT_EQ(sizeof(V), 16u);
    EXPECT_TRUE(std::is_trivially_copyable_v<V>);
}

TEST(VariantDeathTest, ABadTagTraps) {
    V v(A{1});
    v.tag = 3;
    EXPECT_DEATH(name_of(v), "");
}

TEST(TypeList, KnowsPositions) {
    using L = TypeList<A, B, C>;
    EXPECT_EQ((index_of<A, L>), 0);
    EXPECT_EQ((index_of<C, L>), 2);
    EXPECT_EQ(L::size, 3u);
}

TEST(TypeList, VisitsTheTypeAtATag) {
    std::size_t size = 0;
    visit_type<TypeList<A, B, C>>(1, [&](auto tag) { size = sizeof(typename decltype(tag)::type); });
    EXPECT_EQ(size, sizeof(B));
}

TEST(TypeListDeathTest, ABadTagTraps) {
    EXPECT_DEATH((visit_type<TypeList<A, B>>(2, [](auto) {})), "");
}

}  // namespace
}  // namespace ctpbench
