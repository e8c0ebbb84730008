// Files that are written as a whole, locks, and files that are refused.
#include "data/files/write_whole.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "data/files/file_access.h"
#include "data/files/text_file.h"
#include "tests/support/golden.h"

namespace pendular::data_write_whole_test {

using testing::EndsWith;
using testing::Not;

/// Limits the size of files that this process writes, during the life of the object [bytes].
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, signal_);
    }

  private:
    rlimit before_{};
    void (*signal_)(int);
};

TEST(WriteWhole, LeavesTheOldFileAndNoPartsWhenItFails) {
    TemporaryFolder folder;
    write_whole(folder.path() / "new" / "a.txt", "1");
    EXPECT_EQ(read_lines(folder.path() / "new" / "a.txt"), std::vector<std::string>{"1"});
    // A folder in the file's place cannot be replaced by it, whoever runs the test.
    std::filesystem::create_directories(folder.path() / "b.txt" / "inside");
    EXPECT_THROW(write_whole(folder.path() / "b.txt", "2"), std::runtime_error);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().string(), Not(EndsWith(".part")));
}

TEST(WriteWhole, SaysWhyAFileCannotBeWritten) {
    TemporaryFolder folder;
    const std::filesystem::path target = folder.path() / "a.txt";
    const FileSizeLimit limit(10000);  // as a full disk, which takes the first bytes
    try {
        write_whole(target, std::string(100000, 'x'));
        ADD_FAILURE() << "nothing was said";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("a.txt"),
                                                 testing::EndsWith("File too large")));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(WriteWhole, KeepsModeAndOwner) {
    TemporaryFolder folder;
    const auto file = folder.write("a.txt", "1");
    namespace fs = std::filesystem;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    struct stat before = {}, after = {};
    if (getuid() == 0) {
        ASSERT_EQ(chown(file.c_str(), 1234, 4321), 0);
    }
    ASSERT_EQ(stat(file.c_str(), &before), 0);
    write_whole(file, "2");
    ASSERT_EQ(stat(file.c_str(), &after), 0);
    EXPECT_EQ(after.st_mode, before.st_mode);
    EXPECT_EQ(after.st_uid, before.st_uid);
    EXPECT_EQ(after.st_gid, before.st_gid);
    EXPECT_EQ(read_lines(file), std::vector<std::string>{"2"});
}

TEST(WriteWhole, FollowsNoLinkOutOfTheFolder) {
    TemporaryFolder folder, other;
    const auto target = other.write("target", "untouched");
    const auto link = folder.path() / "a.txt";
    std::filesystem::create_symlink(target, link);
    expect_told({input_error([&] { write_whole(link, "2"); })});
    EXPECT_EQ(read_lines(target), std::vector<std::string>{"untouched"});
    std::filesystem::remove(link);
    std::filesystem::create_symlink("b.txt", link);  // to nothing, which would be made
    expect_told({input_error([&] { write_whole(link, "2"); })});
    folder.write("b.txt", "1");
    write_whole(link, "2");  // a link within the folder is the user's
    EXPECT_EQ(read_lines(folder.path() / "b.txt"), std::vector<std::string>{"2"});
    EXPECT_TRUE(std::filesystem::is_symlink(link));
}

TEST(ReadText, RefusesWhatIsNoRegularFileAndWhatIsTooLarge) {
    TemporaryFolder folder;
    expect_told({input_error([] { read_text("/dev/zero"); }),
                 input_error([] { read_text("/proc/self/status"); })});
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    expect_told({input_error([&] { read_text(pipe); })});
    const auto large = folder.write("large.csv", "a\n1\n");
    expect_told({input_error([&] { read_text(large, 3); })});
    std::filesystem::resize_file(large, std::uintmax_t{1} << 40);  // sparse
    expect_told({input_error([&] { read_text(large); })});
}

TEST(FileLock, IsHeldByOne) {
    TemporaryFolder folder;
    const auto file = folder.path() / "lock";
    {
        FileLock first(file), second(file);
        EXPECT_TRUE(first.take());
        EXPECT_FALSE(second.take());
        EXPECT_THAT(second.holder(), testing::HasSubstr("process " + std::to_string(getpid())));
    }
    EXPECT_FALSE(std::filesystem::exists(file));
    std::filesystem::create_symlink(folder.path() / "elsewhere", file);
    EXPECT_THROW(FileLock(file).take(), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "elsewhere"));
}

TEST(Printable, ShowsNoControls) {
    EXPECT_EQ(printable("a\tµ\nb"), "a\tµ\nb");
    EXPECT_EQ(printable("\x1b]0;x\x07"), "\\x1b]0;x\\x07");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m");
    EXPECT_EQ(printable("\u202e"), "\\u202e");
    EXPECT_EQ(printable("\x9b\xff"), "\\x9b\\xff");
}

TEST(WriteWholeFolder, IsThereWholeOrNotAtAll) {
    TemporaryFolder folder;
    const auto names = [](const std::filesystem::path& path) {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    };
    const std::map<std::string, std::string> files = {{"a.txt", "1"}, {"b.txt", "2"}};
    std::filesystem::create_directory(folder.path() / "empty");
    for (const std::string name : {"new", "deep/er", "empty", "slash/"}) {
        write_whole_folder(folder.path() / name, files);
        EXPECT_EQ(names(folder.path() / name), (std::vector<std::string>{"a.txt", "b.txt"}));
        EXPECT_EQ(read_lines(folder.path() / name / "b.txt"), std::vector<std::string>{"2"});
    }
    // A file that cannot be written takes the others with it.
    EXPECT_THROW(write_whole_folder(folder.path() / "bad", {{"a.txt", "1"}, {"no/b.txt", "2"}}),
                 std::runtime_error);
    EXPECT_EQ(names(folder.path()), (std::vector<std::string>{"deep", "empty", "new", "slash"}));
}

TEST(MatchingFiles, FollowEachOtherByTheValueOfTheirNumbers) {
    const TemporaryFolder folder;
    const std::vector<std::string> in_order = {"dry_0.03.csv", "dry_0.2.csv", "dry_2.csv",
                                               "dry_10.csv", "dry_a.csv"};
    for (const std::string& name : in_order)
        write_whole(folder.path() / name, "1");
    std::vector<std::string> found;
    for (const auto& file : matching_files(folder.path(), "dry_*.csv"))
        found.push_back(file.filename());
    // In the order of their bytes, 10 would come before 2.
    EXPECT_EQ(found, in_order);
}

}  // namespace pendular::data_write_whole_test
