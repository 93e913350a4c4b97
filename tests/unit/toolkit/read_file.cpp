// SPDX-License-Identifier: Apache-2.0
//
// A file from outside is read only when it is one and small enough; nothing is waited for.
#include "toolkit/read_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "../../temp_folder.hpp"
#include "toolkit/sentences.hpp"

namespace swage::toolkit {
namespace {

namespace fs = std::filesystem;

class ReadFile : public ::testing::Test {
 protected:
  std::string refused(const std::string& path, std::size_t most = 1000) {
    std::string bytes, why;
    const bool read = read_file(path, most, bytes, why);
    EXPECT_EQ(read, why.empty());
    return why;
  }
  test::TempFolder folder_;
};

TEST_F(ReadFile, GivesTheBytes) {
  const std::string all("a\0b\n\xFF", 5);
  std::ofstream(folder_ / "a", std::ios::binary) << all;
  std::string bytes, why;
  ASSERT_TRUE(read_file(folder_ / "a", 5, bytes, why)) << why;
  EXPECT_EQ(bytes, all);
}

TEST_F(ReadFile, RefusesWhatIsNoFile) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refused(folder_ / "pipe"), say::kPipe()) << "and did not wait for a writer";
  EXPECT_EQ(refused("/dev/zero"), say::kPipe());
  EXPECT_EQ(refused(folder_.path()), say::kFolder());
  EXPECT_EQ(refused(folder_ / "none"), say::kNoFile());
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_EQ(refused(folder_ / "loop"), say::kUnreadable(std::strerror(ELOOP)));
  EXPECT_EQ(refused(folder_ / std::string(300, 'a')), say::kUnreadable(std::strerror(ENAMETOOLONG)));
}

TEST_F(ReadFile, RefusesWhatIsLargerBeforeReadingIt) {
  std::ofstream(folder_ / "large").close();
  fs::resize_file(folder_ / "large", std::uintmax_t{8} << 30);  // a hole: no such disk is needed
  EXPECT_EQ(refused(folder_ / "large", std::size_t{4} << 20), say::kTooLarge("4 MiB"));
  std::ofstream(folder_ / "six") << "123456";
  EXPECT_EQ(refused(folder_ / "six", 5), say::kTooLarge("5 bytes"));
  EXPECT_EQ(file_refusal(folder_ / "six", 6), "");
}

// a file of /proc says that it has no bytes, and has
TEST_F(ReadFile, EndsAtTheLimitWhateverTheFileSaysOfItself) {
  EXPECT_EQ(refused("/proc/self/maps", 100), say::kTooLarge("100 bytes"));
}

}  // namespace
}  // namespace swage::toolkit
