#include "solver/input/file_io.hpp"

#include "solver/input/input_error.hpp"
#include "solver/input/test/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace cleave {
namespace {

TEST(FileIo, WritesWholeFilesAndLeavesNothingElse) {
    const ScratchFolder folder;
    write_file_atomic(folder / "deep" / "a.txt", "first");
    write_file_atomic(folder / "deep" / "a.txt", "second");
    EXPECT_EQ(read_file(folder / "deep" / "a.txt"), "second");
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "deep")) ++files;
    EXPECT_EQ(files, 1);
}

TEST(FileIo, AMissingFileIsInputAndAnUnwritablePlaceEnvironment) {
    EXPECT_THROW(read_file("/nonexistent/x.toml"), InputError);
    EXPECT_THROW(read_file("/"), InputError);
    EXPECT_THROW(write_file_atomic("/proc/cleave/x.txt", "x"), EnvironmentError);
}

TEST(FileIo, HashIsFnv1a) {
    EXPECT_EQ(content_hash(""), "cbf29ce484222325");   // offset basis of the 64-bit FNV-1a
    EXPECT_EQ(content_hash("a"), "af63dc4c8601ec8c");  // published test vector (Fowler, Noll, Vo)
}

}  // namespace
}  // namespace cleave
