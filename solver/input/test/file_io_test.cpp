#include "solver/input/file_io.hpp"

#include "solver/input/input_error.hpp"
#include "solver/input/paths.hpp"
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
    EXPECT_THROW(read_file("/dev/zero"), InputError);
    EXPECT_THROW(write_file_atomic("/proc/cleave/x.txt", "x"), EnvironmentError);
}

TEST(FileIo, ANameTooLongForTheSystemIsOneThatIsNotThere) {
    const std::string name(300, 'a');
    EXPECT_FALSE(is_there(name));
    EXPECT_FALSE(is_file(name));
    EXPECT_THROW(read_file(name), InputError);
    EXPECT_EQ(find_beside(name, "/tmp/x.toml"), name);
}

TEST(FileIo, FindsAFileBesideTheOneThatNamesIt) {
    const ScratchFolder folder;
    write_file_atomic(folder / "a.msh", "x");
    EXPECT_EQ(find_beside("a.msh", folder / "case.toml"), folder / "a.msh");
    EXPECT_EQ(find_beside("b.msh", folder / "case.toml"), "b.msh");
    EXPECT_EQ(find_beside(folder / "a.msh", "elsewhere/case.toml"), folder / "a.msh");
    EXPECT_TRUE(is_there(folder));
    EXPECT_FALSE(is_file(folder));
    EXPECT_TRUE(is_file(folder / "a.msh"));
}

TEST(FileIo, KnowsPathsThatLeadOutside) {
    for (const char* inside : {"a", "a/b.csv", "a/../b", "./a", "..a"}) EXPECT_FALSE(leads_outside(inside)) << inside;
    for (const char* outside : {"", "/a", "..", "../a", "a/../../b"}) EXPECT_TRUE(leads_outside(outside)) << outside;
}

TEST(FileIo, HashIsFnv1a) {
    EXPECT_EQ(content_hash(""), "cbf29ce484222325");   // offset basis of the 64-bit FNV-1a
    EXPECT_EQ(content_hash("a"), "af63dc4c8601ec8c");  // published test vector (Fowler, Noll, Vo)
}

}  // namespace
}  // namespace cleave
