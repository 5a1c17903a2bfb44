// The yardstick of CUDA runs: a fixed kernel for triangles alone, timed beside the contenders as Embree is on
// a CPU. Aila & Laine's while-while loop (HPG 2009) with a stack of node numbers, and Moeller & Trumbore's
// test. It shares no code with the contenders that could be tuned: if it changes, figures of different
// versions can no longer be compared. It ignores spheres.
#pragma once

#include "../dispatch/layout.h"

namespace ctpbench {

struct WhileWhile {
    static constexpr const char* name = "while_while";
    static constexpr TreeKind tree = TreeKind::per_type;

    struct alignas(16) Element {
        float a[3];
        std::uint32_t id;
        float e1[3], unused1;
        float e2[3], unused2;
    };

    struct View {
        const BvhNode* nodes;
        const Element* elements;
    };

    struct Kernel {
        View view;
        IntersectBuffers io;

        CTP_HD void operator()(std::uint32_t i) const {
            const std::uint32_t slot = io.index[i];
            const Ray ray = io.rays.load(slot);
            Hit hit = no_hit(ray);
            if (view.nodes != nullptr) trace(ray, hit);
            io.hits.store(slot, hit);
        }

    private:
        CTP_INLINE static bool enters(const BvhNode& n, Vec3 inv, Vec3 oi, float tmax, float& near) {
            const float x0 = n.bounds[0] * inv.x - oi.x, x1 = n.bounds[3] * inv.x - oi.x;
            const float y0 = n.bounds[1] * inv.y - oi.y, y1 = n.bounds[4] * inv.y - oi.y;
            const float z0 = n.bounds[2] * inv.z - oi.z, z1 = n.bounds[5] * inv.z - oi.z;
            near = max(max(min(x0, x1), min(y0, y1)), max(min(z0, z1), 0.0f));
            return near <= min(min(max(x0, x1), max(y0, y1)), min(max(z0, z1), tmax));
        }
        CTP_INLINE static void test(const Element& e, const Ray& ray, Hit& hit) {
            const Vec3 e1{e.e1[0], e.e1[1], e.e1[2]}, e2{e.e2[0], e.e2[1], e.e2[2]};
            const Vec3 p = cross(ray.direction, e2);
            const float inv = 1.0f / dot(e1, p);
            const Vec3 from = ray.origin - Vec3{e.a[0], e.a[1], e.a[2]};
            const float u = dot(from, p) * inv;
            if (!(u >= 0.0f && u <= 1.0f)) return;
            const Vec3 q = cross(from, e1);
            const float v = dot(ray.direction, q) * inv;
            if (!(v >= 0.0f && u + v <= 1.0f)) return;
            const float t = dot(e2, q) * inv;
            if (hit.accepts(t, e.id)) hit = {t, e.id, u, v};
        }
        CTP_INLINE void trace(const Ray& ray, Hit& hit) const {
            constexpr float tiny = 1e-30f;
            const auto safe = [](float d) { return absolute(d) < tiny ? (d < 0.0f ? -tiny : tiny) : d; };
            const Vec3 inv{1.0f / safe(ray.direction.x), 1.0f / safe(ray.direction.y),
                           1.0f / safe(ray.direction.z)};
            const Vec3 oi = ray.origin * inv;
            std::uint32_t stack[kMaxTreeDepth], top = 0, node = 0;
            while (true) {
                while (!view.nodes[node].is_leaf()) {
                    const std::uint32_t first = view.nodes[node].first;
                    float near0, near1;
                    const bool hit0 = enters(view.nodes[first], inv, oi, hit.t, near0);
                    const bool hit1 = enters(view.nodes[first + 1], inv, oi, hit.t, near1);
                    if (!hit0 && !hit1) {
                        if (top == 0) return;
                        node = stack[--top];
                        continue;
                    }
                    const std::uint32_t next = hit1 && (!hit0 || near1 < near0) ? 1 : 0;
                    if (hit0 && hit1) stack[top++] = first + (1 - next);
                    node = first + next;
                }
                const BvhNode leaf = view.nodes[node];
                for (std::uint32_t i = 0; i < leaf.count(); ++i)
                    test(view.elements[leaf.first + i], ray, hit);
                if (top == 0) return;
                node = stack[--top];
            }
        }
    };

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) : tree_(in.per_type[0]) {
            elements_.reserve(tree_.ref_count);
            for (std::size_t i = 0; i < tree_.ref_count; ++i) {
                const std::uint32_t id = tree_.refs[i].index;
                const TriangleShape t = in.geometry.triangle(id);
                const Vec3 e1 = t.b - t.a, e2 = t.c - t.a;
                elements_.push_back(
                    {{t.a.x, t.a.y, t.a.z}, id, {e1.x, e1.y, e1.z}, 0.0f, {e2.x, e2.y, e2.z}, 0.0f});
            }
        }
        template <class Place>
        View view(const Place& place) const {
            if (elements_.empty()) return {nullptr, nullptr};
            return {place(tree_.nodes, tree_.node_count), place(elements_.data(), elements_.size())};
        }

    private:
        TreeView tree_;
        Array<Element> elements_;
    };

    template <class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        for_each(io.count, Kernel{view, io});
    }
};

}  // namespace ctpbench
