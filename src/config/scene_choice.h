// Where a scene's triangles may come from.
#pragma once

namespace ctpbench {

enum class SceneChoice {
    auto_,     // its mesh if that is there, else its stand-in, with a notice
    real,      // its mesh or an error
    stand_in,  // its stand-in
};

}  // namespace ctpbench
