#include "scene/framing.h"

#include <cmath>
#include <numbers>

namespace ctpbench {

// The box's bounding sphere fits a cone of the camera's angle if the eye is radius / sin(angle / 2) away.
Camera framing_camera(const Box& bounds) {
    Camera camera;
    const float radius = 0.5f * length(bounds.extent());
    const float half_angle = 0.5f * camera.fov_degrees * std::numbers::pi_v<float> / 180.0f;
    const float distance = radius > 0.0f ? radius / std::sin(half_angle) : 1.0f;
    camera.target = bounds.center();
    camera.eye = camera.target + normalize(Vec3{1.0f, 0.6f, 1.0f}) * distance;
    return camera;
}

}  // namespace ctpbench
