// Files appear whole or not at all, in any format; every way to fail says which file and why.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <sstream>

#include "image/pictures.hpp"
#include "image/writer.hpp"

namespace fringe::image {
namespace {

std::string messageOfWriting(const std::filesystem::path& path) {
    try {
        writeImage(path, testPicture(300, 200), {});
    } catch (const FileError& error) {
        return error.what();
    }
    return "(no error)";
}

class Writing : public testing::TestWithParam<const char*> {
protected:
    std::filesystem::path target() const { return folder_ / GetParam(); }

    TestFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Format, Writing, testing::Values("a.png", "a.exr"));

TEST_P(Writing, NothingAppearsBeforeFinish) {
    const Image image = testPicture(300, 200);
    const auto writer = openWriter(target(), image.width, image.height, {});
    writer->writeRows(image.pixels);
    EXPECT_FALSE(std::filesystem::exists(target()));
    writer->finish();
    EXPECT_TRUE(std::filesystem::exists(target()));
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_P(Writing, AnAbandonedFileLeavesNothing) {
    const Image image = testPicture(300, 200);
    openWriter(target(), image.width, image.height, {})->writeRows(image.pixels);
    EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_P(Writing, AnOldFileStaysUntilFinish) {
    putBytes(target(), "old");
    const Image image = testPicture(300, 200);
    openWriter(target(), image.width, image.height, {})->writeRows(image.pixels);
    EXPECT_EQ(bytesOf(target()), "old");
    writeImage(target(), image, {});
    EXPECT_NE(bytesOf(target()), "old");
}

// Two runs at once, or one output named twice: each has a temporary file of its own and the last one wins.
TEST_P(Writing, WritersOfOneNameDoNotMeet) {
    const Image image = testPicture(30, 20), other = testPicture(31, 21);
    const auto first = openWriter(target(), image.width, image.height, {});
    const auto second = openWriter(target(), other.width, other.height, {});
    second->writeRows(other.pixels);
    first->writeRows(image.pixels);
    second->finish();
    first->finish();
    const std::string bytes = bytesOf(target());
    writeImage(target(), image, {});
    EXPECT_EQ(bytesOf(target()), bytes);
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_P(Writing, BandsGiveTheBytesOfTheWhole) {
    const Image image = testPicture(61, 100);
    const OutputOptions options = {
        .development = {.exposure = 0.25}, .nonFiniteChannel = true, .metadata = {{"Software", "Fringe"}}};
    writeImage(target(), image, options);
    const std::string whole = bytesOf(target());
    for (const std::size_t rows : {1U, 7U, 16U, 40U}) {
        const auto writer = openWriter(target(), image.width, image.height, options);
        const std::span<const Pixel> pixels = image.pixels;
        for (std::size_t y = 0; y < image.height; y += rows)
            writer->writeRows(
                pixels.subspan(y * image.width, std::min(rows, image.height - y) * image.width));
        writer->finish();
        EXPECT_EQ(bytesOf(target()), whole) << rows;
    }
}

TEST_P(Writing, PermissionsFollowTheUmask) {
    const mode_t before = ::umask(027);
    writeImage(target(), testPicture(3, 2), {});
    ::umask(before);
    EXPECT_EQ(std::filesystem::status(target()).permissions(), std::filesystem::perms{0640});
}

TEST_P(Writing, ALinkIsFollowed) {
    std::filesystem::create_directory(folder_ / "elsewhere");
    std::filesystem::create_symlink("elsewhere/real", target());  // relative, and its target is yet to appear
    for (int pass = 0; pass < 2; ++pass) {
        writeImage(target(), testPicture(3, 2), {});
        EXPECT_TRUE(std::filesystem::is_symlink(target()));
        EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "elsewhere/real"));
    }
}

TEST_P(Writing, ALoopOfLinksIsAnError) {
    std::filesystem::create_symlink(GetParam(), target());
    EXPECT_EQ(messageOfWriting(target()),
              target().string() + ": cannot be written: Too many levels of symbolic links");
}

TEST_P(Writing, AMissingFolderIsAnError) {
    const auto path = folder_ / "missing" / GetParam();
    EXPECT_EQ(messageOfWriting(path), path.string() + ": cannot create a file in the folder '" +
                                          (folder_ / "missing").string() + "': No such file or directory");
}

TEST_P(Writing, AFolderThatTakesNoFilesIsAnError) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    std::filesystem::permissions(folder_.path(), std::filesystem::perms{0555});
    EXPECT_NE(messageOfWriting(target()).find("Permission denied"), std::string::npos);
    std::filesystem::permissions(folder_.path(), std::filesystem::perms{0755});
}

TEST_P(Writing, AFolderOfThatNameIsAnError) {
    std::filesystem::create_directory(target());
    EXPECT_EQ(messageOfWriting(target()), target().string() + ": is a folder; give the name of a file");
    EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_P(Writing, ADeviceIsNotReplaced) {
    ASSERT_EQ(::mkfifo(target().c_str(), 0600), 0);
    EXPECT_EQ(messageOfWriting(target()),
              target().string() + ": is not a regular file; only such a file can be replaced");
    EXPECT_TRUE(std::filesystem::is_fifo(target()));
}

// A disk that is full after so many bytes: 0 fails in the first write that reaches the system, the others in
// the middle of the pixels. The whole file has more than 10 kB.
TEST_P(Writing, AFullDiskIsAnErrorAndTheOldFileStays) {
    putBytes(target(), "old");
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    std::vector<std::string> messages;
    for (const rlim_t bytes : {0U, 500U, 8192U, 10000U}) {
        const rlimit limited{bytes, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
        messages.push_back(messageOfWriting(target()));
        ::setrlimit(RLIMIT_FSIZE, &before);
    }
    std::signal(SIGXFSZ, oldHandler);
    for (const std::string& message : messages)
        EXPECT_EQ(message, target().string() + ": cannot be written: File too large");
    EXPECT_EQ(bytesOf(target()), "old");
    EXPECT_EQ(folder_.fileCount(), 1U);
}

// A picture so small that all its bytes wait in the stream's buffer until finish().
TEST_P(Writing, AFailureOfTheLastBytesIsAnError) {
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const Image image = testPicture(2, 2);
    const auto writer = openWriter(target(), image.width, image.height, {});
    writer->writeRows(image.pixels);
    const rlimit limited{0, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limited);
    EXPECT_THROW(writer->finish(), FileError);
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    EXPECT_FALSE(std::filesystem::exists(target()));
}

std::size_t peakMemory() {  // bytes
    std::istringstream status(bytesOf("/proc/self/status"));
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            std::size_t kilobytes = 0;
            status >> kilobytes;
            return kilobytes * 1024;
        }
    return 0;
}

// 8 million pixels would take 25 MB as 8 bit samples and 50 MB as halves; a few bands take less than 8 MB.
TEST_P(Writing, MemoryDoesNotGrowWithTheHeight) {
    if (::dlsym(RTLD_DEFAULT, "__asan_init") != nullptr)
        GTEST_SKIP() << "AddressSanitizer keeps freed memory";
    constexpr std::uint32_t width = 1024, height = 8192, rows = 64;
    const Image band = testPicture(width, rows);
    std::ofstream("/proc/self/clear_refs") << "5";  // starts the peak anew
    const std::size_t before = peakMemory();
    const auto writer = openWriter(target(), width, height, {});
    for (std::uint32_t y = 0; y < height; y += rows) writer->writeRows(band.pixels);
    writer->finish();
    ASSERT_GT(before, 0U);
    EXPECT_LT(peakMemory() - before, 8'000'000U);
}

TEST(WritingNames, AnotherExtensionIsAnErrorThatNamesTheTwo) {
    const TestFolder folder;
    for (const char* name : {"a.jpg", "a", ".png", "a.png.txt"})
        EXPECT_EQ(messageOfWriting(folder / name),
                  (folder / name).string() +
                      ": the name does not say which format to write; end it in .png or .exr");
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WritingNames, TheCaseOfTheExtensionDoesNotMatter) {
    const TestFolder folder;
    writeImage(folder / "A.PNG", testPicture(3, 2), {});
    writeImage(folder / "A.Exr", testPicture(3, 2), {});
    EXPECT_EQ(bytesOf(folder / "A.PNG").substr(1, 3), "PNG");
    EXPECT_EQ(bytesOf(folder / "A.Exr").substr(0, 2), "v/");
}

TEST(WritingNames, ANameWithoutFolderIsInTheCurrentOne) {
    const TestFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    writeImage("a.png", testPicture(3, 2), {});
    std::filesystem::current_path(before);
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
}

}  // namespace
}  // namespace fringe::image
