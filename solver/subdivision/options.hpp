#pragma once

namespace cleave::subdivision {

struct Options {
    double tau = 0.1;  ///< see vertex_distances
    int threads = 1;   ///< of the engine, at most; results are the same bytes for any number. 0: all that oneTBB offers
};

}  // namespace cleave::subdivision
