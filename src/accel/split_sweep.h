// The cheapest of the places to cut a row of boxes in two. Costs are areas times counts, so a box without
// area costs nothing instead of dividing by zero; among equals the most even split wins.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "accel/bin_grid.h"
#include "accel/reference.h"

namespace ctpbench {

// Where the split is and what it gives.
struct SplitSides {
    double cost = std::numeric_limits<double>::infinity();  // area times count, summed over the sides
    std::uint32_t left = 0, right = 0;                      // references
    Bounds4 left_box = Bounds4::empty(), right_box = Bounds4::empty();

    bool exists() const { return left > 0 && right > 0; }
    // The sides of a cut before box `position` of a row.
    void set_boxes(const Bounds4* boxes, std::uint32_t count, std::uint32_t position) {
        left_box = right_box = Bounds4::empty();
        for (std::uint32_t b = 0; b < position; ++b) left_box.extend(boxes[b]);
        for (std::uint32_t b = position; b < count; ++b) right_box.extend(boxes[b]);
    }
};

// Goes from the left to the right over at most kMaxBins boxes.
class SplitSweep {
public:
    SplitSweep(const Bounds4* boxes, std::uint32_t count) : boxes_(boxes) {
        Bounds4 box = Bounds4::empty();
        for (std::uint32_t b = count; b-- > 1;) {
            box.extend(boxes[b]);
            right_area_[b] = box.half_area();
        }
    }

    // The next cut, before box 1 first, leaves these many references on the two sides.
    void try_next(std::uint32_t left, std::uint32_t right, SplitSides& best) {
        pass();
        if (left == 0 || right == 0) return;
        const double cost = double{left_.half_area()} * left + double{right_area_[at_]} * right;
        if (cost > best.cost) return;
        if (cost == best.cost && std::max(left, right) >= std::max(best.left, best.right)) return;
        best.cost = cost;
        best.left = left;
        best.right = right;
        position_ = at_;
    }
    // Leaves the next cut out.
    void pass() { left_.extend(boxes_[at_++]); }

    // Whether one of these cuts is the best. Then it is before box position().
    bool improved() const { return position_ > 0; }
    std::uint32_t position() const { return position_; }

private:
    const Bounds4* boxes_;
    std::uint32_t at_ = 0, position_ = 0;
    Bounds4 left_ = Bounds4::empty();
    std::array<float, kMaxBins> right_area_;
};

}  // namespace ctpbench
