// A camera for a scene that comes without one.
#pragma once

#include "scene/scene.h"

namespace ctpbench {

// Sees all of the box, from its front upper right; Y is up.
Camera framing_camera(const Box& bounds);

}  // namespace ctpbench
