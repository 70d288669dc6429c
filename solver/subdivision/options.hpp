#pragma once

namespace cleave::subdivision {

struct Options {
    double tau = 0.1;  ///< see vertex_distances
    int threads = 1;   ///< of the engine, at most; results are the same bytes for any number. 0: all that oneTBB offers
    /// Parents of one cut from which on their children are written past the caches; the same bytes either way. The children of so many
    /// take some 18 MB, those of fewer are better left in the caches.
    int streamed_from = 16 * 1024;
};

}  // namespace cleave::subdivision
