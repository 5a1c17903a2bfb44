// The installed Embree, and what its versions 3 and 4 call differently. Nothing in a program without Embree.
#pragma once

#ifdef CTPBENCH_EMBREE

#if CTPBENCH_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace ctpbench {

#if CTPBENCH_EMBREE == 4

// What a call is told beside its rays. Coherent: rays are expected to take much the same way.
class EmbreeQuery {
public:
    explicit EmbreeQuery(bool coherent) {
        rtcInitIntersectArguments(&arguments_);
        if (coherent) arguments_.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    }
    static void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray); }
    void intersect(RTCScene scene, const int* valid, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &rays, &arguments_);
    }

private:
    RTCIntersectArguments arguments_;
};

#else

class EmbreeQuery {
public:
    explicit EmbreeQuery(bool coherent) {
        rtcInitIntersectContext(&context_);
        if (coherent) context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    }
    void intersect(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &context_, &ray); }
    void intersect(RTCScene scene, const int* valid, RTCRayHit16& rays) {
        rtcIntersect16(valid, scene, &context_, &rays);
    }
    void intersect(RTCScene scene, const RTCRayHitNp& rays, unsigned count) {
        rtcIntersectNp(scene, &context_, &rays, count);
    }

private:
    RTCIntersectContext context_;
};

#endif

}  // namespace ctpbench

#endif
