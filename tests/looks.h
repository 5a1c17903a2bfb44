// Descriptions of materials in a line each.
#pragma once

#include "kernels/materials/list.h"

namespace ctpbench::test {

inline Vec3 gray(float value) { return {value, value, value}; }

inline MaterialDescription matte(Vec3 albedo) {
    MaterialDescription d;
    d.type = material_type<Matte>, d.diffuse = albedo;
    return d;
}

inline MaterialDescription plastic(Vec3 diffuse, Vec3 specular, float exponent) {
    MaterialDescription d;
    d.type = material_type<Plastic>, d.diffuse = diffuse, d.specular = specular, d.exponent = exponent;
    return d;
}

inline MaterialDescription mirror(Vec3 reflectance) {
    MaterialDescription d;
    d.type = material_type<Mirror>, d.diffuse = gray(0.0f), d.specular = reflectance;
    return d;
}

inline MaterialDescription emissive(Vec3 radiance) {
    MaterialDescription d;
    d.type = material_type<Emissive>, d.diffuse = gray(0.0f), d.emission = radiance;
    return d;
}

}  // namespace ctpbench::test
