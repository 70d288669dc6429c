#pragma once

namespace cleave::subdivision {

struct Options {
    double tau = 0.1;  ///< see vertex_distances
};

}  // namespace cleave::subdivision
