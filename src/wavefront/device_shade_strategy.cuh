// A shade strategy on a device. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/device_shader_groups.cuh"
#include "wavefront/device_typed_shade.cuh"
#include "wavefront/placed_materials.h"

namespace ctpbench {

// A strategy that looks materials up in a table, whatever their type.
template <class Table, class Offset>
class OneKernel final : public DeviceShader {
public:
    explicit OneKernel(const Table& table) : table_(table) {}

    PathOrder order() const override { return PathOrder::as_traced; }
    bool excludes() const override { return Offset::excludes; }
    std::uint32_t kernels() const override { return 1; }
    const char* kernel_name(std::uint32_t) const override { return nullptr; }
    void launch(std::uint32_t, cudaStream_t stream, const ShadeBuffers& io,
                const DeviceShadeWork& work) const override {
        launch_for_each(stream, {work.most, work.count}, ShadeAnyKernel<Table, Offset>{table_, io}, "shade");
    }

private:
    Table table_;
};

// A kernel per type, and one for paths that hit nothing.
template <class Offset, class Types>
class KernelPerType final : public DeviceShader {
public:
    KernelPerType(PathOrder order, const typename TypedMaterialArrays<Types>::View& view)
        : order_(order), view_(view) {
        int device = 0, multiprocessors = 0;
        check_cuda(cudaGetDevice(&device), "asking for the device");
        check_cuda(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device),
                   "asking for the number of multiprocessors");
        most_blocks_ = 8 * static_cast<std::uint32_t>(multiprocessors);
    }

    PathOrder order() const override { return order_; }
    bool excludes() const override { return Offset::excludes; }
    std::uint32_t kernels() const override { return Types::size + 1; }
    const char* kernel_name(std::uint32_t kernel) const override {
        const char* name = "miss";
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (kernel == index_of<T, Types>) name = T::name;
        });
        return name;
    }
    void launch(std::uint32_t kernel, cudaStream_t stream, const ShadeBuffers& io,
                const DeviceShadeWork& work) const override {
        if (kernel == Types::size) launch_key(kernel, Outside{}, stream, io, work);
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (kernel == index_of<T, Types>) launch_key(kernel, view_.template of<T>(), stream, io, work);
        });
    }

private:
    template <class Shading>
    void launch_key(std::uint32_t key, const Shading& shading, cudaStream_t stream, const ShadeBuffers& io,
                    const DeviceShadeWork& work) const {
        if (order_ != PathOrder::queued)
            launch_list(ShadeSortedRun<Shading, Offset>{shading, io, work.positions, work.key_offsets + key},
                        stream, work);
        else
            launch_list(
                ShadeQueue<Shading, Offset>{
                    shading, io, work.queues.slots + std::size_t{key} * work.queues.capacity,
                    work.queues.counts + key, work.survivors, work.survivor_count, work.dropped},
                stream, work);
    }
    template <class Kernel>
    void launch_list(const Kernel& kernel, cudaStream_t stream, const DeviceShadeWork& work) const {
        const std::uint32_t blocks = (work.most + kBlockThreads - 1) / kBlockThreads;
        const std::uint32_t grid = blocks < most_blocks_ ? blocks : most_blocks_;
        counted_kernel<<<grid, kBlockThreads, 0, stream>>>(kernel);
        check_launch("shade");
    }

    PathOrder order_;
    typename TypedMaterialArrays<Types>::View view_;
    std::uint32_t most_blocks_ = 0;
};

template <class Offset, class Types>
std::unique_ptr<DeviceShader> shader_with_types(const DevicePlace& place, std::string_view strategy,
                                                const MaterialInput& materials) {
    std::unique_ptr<DeviceShader> made;
    for_each_type(ShadeStrategies<Types>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy != Strategy::name) return;
        const auto view = materials_in<Strategy>(place, materials);
        if constexpr (Strategy::order == PathOrder::as_traced)
            made = std::make_unique<OneKernel<std::remove_const_t<decltype(view)>, Offset>>(view);
        else
            made = std::make_unique<KernelPerType<Offset, Types>>(Strategy::order, view);
    });
    return made;
}

template <class Offset>
std::unique_ptr<DeviceShader> make_on_device_with_offset(const DevicePlace& place, std::string_view strategy,
                                                         const MaterialInput& materials) {
    std::unique_ptr<DeviceShader> made;
    visit_material_list<Offset>(materials.types, [&](auto list) {
        made = shader_with_types<Offset, typename decltype(list)::type>(place, strategy, materials);
    });
    return made;
}

}  // namespace ctpbench
