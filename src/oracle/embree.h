// Embree as the reference for hits and as the yardstick of throughput: triangles and sphere points, traced in
// each way that it has from the same columns as our own contenders.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oracle/embree_scene.h"
#include "wavefront/intersector.h"

namespace ctpbench {

// rtcIntersect1, rtcIntersect16 or rtcIntersectNp (a stream, in Embree 3 alone).
enum class EmbreeCall { one, packet, stream };

struct EmbreeContender {
    std::string name;
    EmbreeMode mode;
    EmbreeCall call;
    bool coherent;  // whether Embree is told that rays are; packets and streams alone
};
// The yardstick contenders that configs may name.
std::vector<EmbreeContender> embree_contenders();

// Why this program has not the contender of that name; empty if it has, or if there is none of that name.
std::string embree_obstacle(const std::string& name);

// "3.13.5", or empty if this program was built without Embree.
std::string embree_version();

// There must be no obstacle.
std::unique_ptr<Intersector> make_embree(std::shared_ptr<const EmbreeScene> scene, EmbreeCall call,
                                         bool coherent = false);

// rtcIntersect1 with a tree of its own. Throws Error(no_backend) without Embree.
std::unique_ptr<Intersector> make_embree(const Scene& scene, EmbreeMode mode, int threads);

}  // namespace ctpbench
