// A Lambertian base under a glossy lobe: a microfacet term with Blinn's distribution of half vectors and
// V-shaped grooves (Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977;
// normalised as in Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007):
//
//     f = kd / pi + ks D(h) G / (4 cos_o cos_i),   D(h) = (n + 2) / (2 pi) cos_h^n
//
// Together they reflect no more than arrives if kd + ks <= 1; make() scales both down where they would.
#pragma once

#include "../surface.h"
#include "diffuse_color.h"

namespace ctpbench {

// Color: diffuse_color.h.
template <class Color>
struct PlasticOf {
    static constexpr const char* name = "plastic";

    Color color;
    Vec3 specular;
    float exponent;
    float diffuse_share;  // probability of picking the Lambertian lobe

    static PlasticOf make(const MaterialDescription& d) {
        PlasticOf p{Color::make(d), d.specular, d.exponent, 0.0f};
        const Vec3 sum = p.color.factor + p.specular;
        const float largest = max(max(sum.x, sum.y), sum.z);
        if (largest > 1.0f) {
            p.color.factor = p.color.factor * (1.0f / largest);
            p.specular = p.specular * (1.0f / largest);
        }
        const float kd = mean(p.color.factor), ks = mean(p.specular);
        p.diffuse_share = kd + ks > 0.0f ? kd / (kd + ks) : 1.0f;
        return p;
    }

    CTP_INLINE Vec3 shade(const SurfacePoint& point, Vec3 wi) const {
        Vec3 albedo;
        const float cos_i = dot(point.normal, wi), cos_o = dot(point.normal, point.wo);
        if (!color.at(point, albedo) || cos_i <= 0.0f || cos_o <= 0.0f) return {0.0f, 0.0f, 0.0f};
        const HalfVector h = between(point.wo, wi, cos_o, cos_i);
        const float d = (exponent + 2.0f) * (0.5f * kInvPi) * std::pow(h.cos_h, exponent);
        return albedo * kInvPi +
               specular * (d * grooves(h.cos_h, cos_o, cos_i, h.oh) / (4.0f * cos_o * cos_i));
    }

    // Of both lobes together. Half vectors are drawn with density D cos_h.
    CTP_INLINE float pdf(const SurfacePoint& point, Vec3 wi) const {
        const float cos_i = dot(point.normal, wi), cos_o = dot(point.normal, point.wo);
        if (cos_i <= 0.0f) return 0.0f;
        const float diffuse = diffuse_share * cos_i * kInvPi;
        if (cos_o <= 0.0f) return diffuse;
        const HalfVector h = between(point.wo, wi, cos_o, cos_i);
        const float glossy =
            (exponent + 2.0f) * (0.5f * kInvPi) * std::pow(h.cos_h, exponent + 1.0f) / (4.0f * h.oh);
        return diffuse + (1.0f - diffuse_share) * glossy;
    }

    // Picks a lobe and divides by the probability of having picked it.
    CTP_INLINE Scattering sample(const SurfacePoint& point, const PathRandom& random) const {
        Vec3 albedo;
        if (!color.at(point, albedo)) return without_light(ScatterEvent::passed);
        const Random4 r = random.draw();
        if (r.v[2] < diffuse_share)
            return scattered(cosine_direction(point.normal, r.v[0], r.v[1]), albedo * (1.0f / diffuse_share));

        const float cos_h = std::pow(1.0f - r.v[0], 1.0f / (exponent + 2.0f));
        const Vec3 h = direction_about(point.normal, cos_h, r.v[1]);
        const float oh = dot(point.wo, h);
        const Vec3 wi = 2.0f * oh * h - point.wo;
        const float cos_i = dot(point.normal, wi), cos_o = dot(point.normal, point.wo);
        if (oh <= 0.0f || cos_i <= 0.0f || cos_o <= 0.0f) return without_light(ScatterEvent::dropped);
        // D cancels; what is left is at most 2.
        const float weight = grooves(cos_h, cos_o, cos_i, oh) * oh / (cos_o * cos_h);
        return scattered(wi, specular * (weight / (1.0f - diffuse_share)));
    }

private:
    struct HalfVector {
        float cos_h, oh;  // with the normal, and with wo and wi alike
    };
    // For cosines above 0. Where light passes on along the surface wo + wi is nearly nothing, and dot
    // products with its direction would be rounding errors of either sign; its length never is.
    CTP_INLINE static HalfVector between(Vec3 wo, Vec3 wi, float cos_o, float cos_i) {
        const float l = length(wo + wi);
        return {min((cos_o + cos_i) / l, 1.0f), 0.5f * l};
    }
    CTP_INLINE static float mean(Vec3 v) { return (v.x + v.y + v.z) * (1.0f / 3.0f); }
    // The share of a groove's facets that is neither hidden nor in shadow.
    CTP_INLINE static float grooves(float cos_h, float cos_o, float cos_i, float oh) {
        return min(1.0f, 2.0f * cos_h * min(cos_o, cos_i) / oh);
    }
};

using Plastic = PlasticOf<DiffuseColor>;

}  // namespace ctpbench
