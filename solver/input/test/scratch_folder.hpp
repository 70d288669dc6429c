// A folder of a test's own.
#pragma once

#include <gtest/gtest.h>

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace cleave {

/// An empty folder that no other test has, gone with the object. CTest runs every TEST as a process of its own, several at a time: a name
/// two tests share below the temporary folder is a race.
class ScratchFolder {
public:
    /// @throws std::runtime_error where the temporary folder cannot be written
    ScratchFolder() {
        std::string pattern = (std::filesystem::path(testing::TempDir()) / "cleave-test-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(testing::TempDir() + ": expected a writable folder");
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    operator const std::filesystem::path&() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace cleave
