#pragma once

#include <benchmark/benchmark.h>

#include <sstream>
#include <string>
#include <vector>

namespace cleave::benchmarks {

/// Prints to the console as Google Benchmark does, and keeps its JSON.
class JsonReporter : public benchmark::ConsoleReporter {
public:
    JsonReporter();
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;
    void Finalize() override;

    /// The JSON without what belongs to the machine's owner (host name, path of the program), rows named as registered.
    std::string json() const;

private:
    std::ostringstream text_;
    benchmark::JSONReporter json_;
};

/// cpu_model, compiler, build_type, threads, level: into the JSON's context.
void add_context(const std::string& level);

/// The processor's name in /proc/cpuinfo; "unknown" where it has none.
std::string cpu_model(std::istream& cpuinfo);

}  // namespace cleave::benchmarks
