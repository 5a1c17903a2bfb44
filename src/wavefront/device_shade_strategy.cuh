// A shade strategy on a device. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/device_objects.cuh"
#include "wavefront/device_shader_groups.cuh"
#include "wavefront/device_typed_shade.cuh"

namespace ctpbench {

// A strategy that looks materials up in a table, whatever their type.
template <class Table, class Offset>
class OneKernel final : public DeviceShader {
public:
    OneKernel(DevicePlace place, const Table& table) : place_(std::move(place)), table_(table) {}

    PathOrder order() const override { return PathOrder::as_traced; }
    bool excludes() const override { return Offset::excludes; }
    std::uint32_t kernels() const override { return 1; }
    const char* kernel_name(std::uint32_t) const override { return nullptr; }
    void launch(std::uint32_t, cudaStream_t stream, const ShadeBuffers& io,
                const DeviceShadeWork& work) const override {
        launch_for_each(stream, {work.most, work.count}, ShadeAnyKernel<Table, Offset>{table_, io}, "shade");
    }

private:
    DevicePlace place_;
    Table table_;
};

// A kernel per type, and one for paths that hit nothing.
template <class Offset>
class KernelPerType final : public DeviceShader {
public:
    KernelPerType(PathOrder order, const MaterialInput& materials)
        : order_(order), view_(TypedMaterialArrays(materials).view(place_)) {
        int device = 0, multiprocessors = 0;
        check_cuda(cudaGetDevice(&device), "asking for the device");
        check_cuda(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device),
                   "asking for the number of multiprocessors");
        most_blocks_ = 8 * static_cast<std::uint32_t>(multiprocessors);
    }

    PathOrder order() const override { return order_; }
    bool excludes() const override { return Offset::excludes; }
    std::uint32_t kernels() const override { return kShadeKeys; }
    const char* kernel_name(std::uint32_t kernel) const override {
        const char* name = "miss";
        for_each_type(Materials{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (kernel == material_type<T>) name = T::name;
        });
        return name;
    }
    void launch(std::uint32_t kernel, cudaStream_t stream, const ShadeBuffers& io,
                const DeviceShadeWork& work) const override {
        if (kernel == kMissKey) launch_key(kernel, Outside{}, stream, io, work);
        for_each_type(Materials{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (kernel == material_type<T>) launch_key(kernel, view_.template of<T>(), stream, io, work);
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
                    &work.queues.counts->of[key], work.survivors, work.survivor_count, work.dropped},
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
    DevicePlace place_;
    TypedMaterialArrays::View view_;
    std::uint32_t most_blocks_ = 0;
};

// Base-class pointers by material number.
struct PointToMaterial {
    const MaterialBase** pointers;
    const MaterialBase* object;

    __device__ void operator()(std::uint32_t) const { *pointers = object; }
};

// As on the host, `oop` has its objects apart and `oop_arena` has those of one type together.
inline VirtualMaterials virtual_materials(const MaterialInput& in, const DevicePlace& place, bool apart) {
    auto* pointers =
        static_cast<const MaterialBase**>(place.reserve(in.count() * sizeof(const MaterialBase*)));
    for_each_type(Materials{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        Array<T> values;
        for (std::uint32_t i = in.first[material_type<T>]; i < in.first[material_type<T> + 1]; ++i)
            values.push_back(T::make(in.descriptions[i]));
        MaterialObject<T>* objects = apart ? nullptr : construct_objects<MaterialObject<T>>(place, values);
        for (std::uint32_t i = 0; i < values.size(); ++i) {
            const MaterialObject<T>* object =
                apart ? construct_objects<MaterialObject<T>>(place, Array<T>{values[i]}) : objects + i;
            launch_for_each(nullptr, {1}, PointToMaterial{pointers + in.first[material_type<T>] + i, object},
                            "pointing to materials");
        }
    });
    check_cuda(cudaDeviceSynchronize(), "pointing to materials");
    return {pointers};
}

template <class Offset, class Table>
std::unique_ptr<DeviceShader> one_kernel(DevicePlace place, const Table& table) {
    return std::make_unique<OneKernel<Table, Offset>>(std::move(place), table);
}

template <class Strategy, class Offset>
std::unique_ptr<DeviceShader> shader_for(const MaterialInput& materials) {
    DevicePlace place;
    if constexpr (Strategy::order != PathOrder::as_traced) {
        return std::make_unique<KernelPerType<Offset>>(Strategy::order, materials);
    } else if constexpr (std::is_same_v<Strategy, ShadeOop> || std::is_same_v<Strategy, ShadeOopArena>) {
        const VirtualMaterials table =
            virtual_materials(materials, place, std::is_same_v<Strategy, ShadeOop>);
        return one_kernel<Offset>(std::move(place), table);
    } else {
        const auto table = typename Strategy::Layout(materials).view(place);
        return one_kernel<Offset>(std::move(place), table);
    }
}

template <class Offset>
std::unique_ptr<DeviceShader> make_on_device_with_offset(std::string_view strategy,
                                                         const MaterialInput& materials) {
    std::unique_ptr<DeviceShader> made;
    for_each_type(ShadeStrategies{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = shader_for<Strategy, Offset>(materials);
    });
    return made;
}

}  // namespace ctpbench
