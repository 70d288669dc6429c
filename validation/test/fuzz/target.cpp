#include "validation/test/fuzz/target.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace cleave::fuzz {

namespace {

namespace fs = std::filesystem;

/// Gone with the process.
class OwnFolder {
public:
    OwnFolder() {
        std::string pattern = (fs::temp_directory_path() / "cleave-fuzz-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw EnvironmentError(pattern + ": expected a writable folder");
        path_ = pattern;
    }
    ~OwnFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

}  // namespace

bool accepts(const Target& target, const std::string& bytes) try {
    target.read(bytes);
    return true;
} catch (const InputError&) {
    return false;
}

fs::path input_file(const std::string& name, const std::string& bytes) {
    static const OwnFolder folder;
    const fs::path path = folder.path() / name;
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw EnvironmentError(path.string() + ": cannot be written");
    return path;
}

std::vector<std::string> texts_in(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ending) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const fs::path& file : files) texts.push_back(read_file(file));
    return texts;
}

}  // namespace cleave::fuzz
