#pragma once

#include "benchmarks/subdivision_work.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace cleave::benchmarks {

/// Makes a body at its first use. Large ones are dropped when the next large one is made: rows are registered body by body, and
/// millions of tets need gigabytes.
class LazyCase {
public:
    using Make = std::function<SubdivisionCase()>;
    LazyCase(Make make, std::shared_ptr<LazyCase*> large) : make_(std::move(make)), large_(std::move(large)) {}
    const SubdivisionCase& get();

private:
    Make make_;
    std::shared_ptr<LazyCase*> large_;  ///< the one large body in memory
    std::unique_ptr<SubdivisionCase> made_;
};

/// The bodies of the rows. Copies of what it returns keep a body alive.
class Bodies {
public:
    std::shared_ptr<LazyCase> add(LazyCase::Make make) const { return std::make_shared<LazyCase>(std::move(make), large_); }
    /// cube_case(cells), one object for all rows that ask for it.
    std::shared_ptr<LazyCase> cube(int cells);
    std::shared_ptr<LazyCase> pot();

private:
    std::shared_ptr<LazyCase*> large_ = std::make_shared<LazyCase*>(nullptr);
    std::map<int, std::shared_ptr<LazyCase>> cubes_;
    std::shared_ptr<LazyCase> pot_;
};

}  // namespace cleave::benchmarks
