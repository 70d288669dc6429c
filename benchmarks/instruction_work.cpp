// The work whose instructions `cleave bench --instructions` counts: cuts a cube of CELLS^3 cells once and prints the children.
// A program of its own, because valgrind runs it (some 50 times slower than the processor).

#include "benchmarks/subdivision_work.hpp"
#include "solver/subdivision/subdivision_engine.hpp"

#include <cstdio>
#include <cstdlib>

/// callgrind counts inside this function only. A plain name, so that it can be told on valgrind's command line.
extern "C" [[gnu::noinline]] void cleave_counted_work(cleave::subdivision::SubdivisionEngine* engine, const cleave::subdivision::Cut* cut,
                                                      cleave::subdivision::Buffer<cleave::subdivision::ExtraLink>* links) {
    engine->cut(*cut);
    engine->find_extra_links(*links);
}

int main(int argc, char** argv) {
    const int cells = argc == 2 ? std::atoi(argv[1]) : 0;
    if (cells < 1) return 2;
    const cleave::benchmarks::SubdivisionCase body = cleave::benchmarks::cube_case(cells);
    cleave::subdivision::SubdivisionEngine engine(body.mesh);
    cleave::subdivision::Buffer<cleave::subdivision::ExtraLink> links;
    cleave_counted_work(&engine, &body.cut, &links);
    std::printf("%zu\n", engine.child_tets().size());
}
