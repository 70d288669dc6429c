#include "benchmarks/json_reporter.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <thread>

namespace cleave::benchmarks {

namespace {

/// The name as registered: without Google Benchmark's notes on how it was timed.
std::string plain_name(const std::string& name) {
    const std::size_t notes = std::min(name.find("/iterations:"), name.find("/manual_time"));
    return name.substr(0, notes);
}

}  // namespace

JsonReporter::JsonReporter() : ConsoleReporter(OO_Tabular) { json_.SetOutputStream(&text_); }

bool JsonReporter::ReportContext(const Context& context) {
    json_.ReportContext(context);
    return ConsoleReporter::ReportContext(context);
}

void JsonReporter::ReportRuns(const std::vector<Run>& runs) {
    json_.ReportRuns(runs);
    ConsoleReporter::ReportRuns(runs);
}

void JsonReporter::Finalize() {
    json_.Finalize();
    ConsoleReporter::Finalize();
}

std::string JsonReporter::json() const {
    nlohmann::ordered_json document = nlohmann::ordered_json::parse(text_.str());
    document["context"].erase("host_name");
    document["context"].erase("executable");
    for (auto& row : document["benchmarks"]) {
        for (const char* key : {"name", "run_name"}) row[key] = plain_name(row[key].get<std::string>());
    }
    return document.dump(1) + "\n";
}

void add_context(const std::string& level) {
    std::ifstream cpuinfo("/proc/cpuinfo");
    benchmark::AddCustomContext("cpu_model", cpu_model(cpuinfo));
    benchmark::AddCustomContext("compiler", "g++ " __VERSION__);
    benchmark::AddCustomContext("build_type", CLEAVE_BUILD_TYPE);
    benchmark::AddCustomContext("threads", std::to_string(std::thread::hardware_concurrency()));
    benchmark::AddCustomContext("level", level);
}

std::string cpu_model(std::istream& cpuinfo) {
    for (std::string line; std::getline(cpuinfo, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with("model name") && colon != std::string::npos && colon + 2 <= line.size()) return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace cleave::benchmarks
