// Files, locks and replacing on Windows: what the tests of other systems show with means of POSIX.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../../unit/scratch.h"
#include "platform/durable_file.h"
#include "platform/file.h"
#include "platform/file_lock.h"
#include "platform/unique_name.h"

namespace weftlight::platform {
namespace {

namespace fs = std::filesystem;

class FilesOfWindows : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_ / name; }
  std::string written(const std::string& name, const std::string& text) const {
    File file(path(name), File::Open::kCreate);
    EXPECT_FALSE(file.error()) << file.error().message();
    EXPECT_FALSE(file.write(text));
    EXPECT_FALSE(file.sync());
    EXPECT_FALSE(file.close());
    return path(name);
  }
  static std::string text_of(const std::string& path) {
    File file(path, File::Open::kRead);
    std::string text(100, '\0');
    std::error_code error;
    if (file.error()) return "not opened: " + file.error().message();
    text.resize(file.read(text.data(), text.size(), error));
    return error ? error.message() : text;
  }
  std::vector<std::string> names() const {
    std::error_code error;
    return names_in(scratch_.folder.string(), error);
  }
  const Scratch scratch_;
};

constexpr const char* kName =
    "K\xC3\xB6per \xE7\xB9\x94 \xD0\x96 \xF0\x9F\xA7\xB5.wif";  // German, Japanese, Cyrillic, a spool

TEST_F(FilesOfWindows, keep_bytes_and_names_as_they_are) {
  written(kName, "a\r\nb\nc\x1a");
  EXPECT_EQ(text_of(path(kName)), "a\r\nb\nc\x1a");
  EXPECT_EQ(names(), std::vector<std::string>{kName});
  EXPECT_TRUE(fs::exists(scratch_.folder / fs::path(reinterpret_cast<const char8_t*>(kName))));
  File more(path(kName), File::Open::kAppend);
  EXPECT_FALSE(more.write("d"));
  EXPECT_FALSE(more.close());
  EXPECT_EQ(file_facts(path(kName)).size, 8u);
  EXPECT_EQ(File(path(kName), File::Open::kCreate).error(), std::errc::file_exists);
}

TEST_F(FilesOfWindows, are_told_apart_from_folders_and_from_nothing) {
  written("a", ""), written("b", "");
  EXPECT_EQ(file_facts(path("")).kind, FileKind::kFolder);
  EXPECT_EQ(file_facts(path("none")).kind, FileKind::kNone);
  EXPECT_EQ(file_facts("NUL").kind, FileKind::kStream);
  EXPECT_EQ(File(path(""), File::Open::kRead).facts().kind, FileKind::kFolder);
  EXPECT_EQ(File(path("none"), File::Open::kRead).error(), std::errc::no_such_file_or_directory);
  EXPECT_EQ(File(path("none/a"), File::Open::kCreate).error(), std::errc::no_such_file_or_directory);
  EXPECT_NE(file_facts(path("a")).number, file_facts(path("b")).number);
  EXPECT_EQ(file_facts(path("a")).number, File(path("a"), File::Open::kRead).facts().number);
  EXPECT_GT(file_facts(path("a")).modified_ns, int64_t{1'700'000'000} * 1'000'000'000);
}

TEST_F(FilesOfWindows, replace_others_whole) {
  written("a.wif", "old");
  DurableFile file(path("a.wif"));
  ASSERT_FALSE(file.error()) << file.error().message();
  EXPECT_TRUE(is_temporary_of(path("a.wif"), fs::path(file.beside()).filename().string()));
  EXPECT_EQ(FileLock::take_existing(file.beside()).answer(), LockAnswer::kTaken);
  File beside(file.beside(), File::Open::kReplace);
  EXPECT_FALSE(beside.write("new"));
  EXPECT_FALSE(beside.close());
  EXPECT_EQ(text_of(path("a.wif")), "old");
  EXPECT_FALSE(file.put_in_place());
  EXPECT_EQ(text_of(path("a.wif")), "new");
  { const DurableFile given_up(path("a.wif")); }
  EXPECT_EQ(names(), std::vector<std::string>{"a.wif"});
}

TEST_F(FilesOfWindows, that_are_read_only_stay) {
  fs::permissions(written("a.wif", "old"), fs::perms::owner_read);
  EXPECT_EQ(why_not_replaced(path("a.wif")), std::errc::permission_denied);
  EXPECT_EQ(DurableFile(path("a.wif")).error(), std::errc::permission_denied);
  EXPECT_FALSE(why_not_replaced(path("new.wif")));
  EXPECT_TRUE(why_not_replaced(path("none/new.wif")));
  EXPECT_EQ(names(), std::vector<std::string>{"a.wif"});
  EXPECT_FALSE(remove_with_contents(path("a.wif")));
  EXPECT_TRUE(names().empty());
}

TEST_F(FilesOfWindows, in_a_folder_replace_an_empty_one_only) {
  for (const char* name : {"made/within", "empty", "full"}) EXPECT_FALSE(make_folders(path(name)));
  written("made/within/one", "1"), written("full/two", "2");
  EXPECT_TRUE(put_in_place(path("made"), path("full")));
  EXPECT_EQ(text_of(path("full/two")), "2");
  EXPECT_FALSE(put_in_place(path("made"), path("empty")));
  EXPECT_EQ(text_of(path("empty/within/one")), "1");
  EXPECT_FALSE(remove_with_contents(path("empty")));
  EXPECT_EQ(names(), std::vector<std::string>{"full"});
}

TEST_F(FilesOfWindows, have_one_owner) {
  {
    const FileLock lock = FileLock::take(path("lock"));
    ASSERT_TRUE(lock.held()) << lock.cause().message();
    EXPECT_TRUE(lock.stands_at(path("lock")));
    EXPECT_EQ(FileLock::take(path("lock")).answer(), LockAnswer::kTaken);
    EXPECT_EQ(text_of(path("lock")), "") << "others can read it";
    EXPECT_FALSE(rename(path("lock"), path("moved")));
    EXPECT_FALSE(lock.stands_at(path("lock")));
    EXPECT_EQ(FileLock::take_existing(path("moved")).answer(), LockAnswer::kTaken);
    EXPECT_EQ(FileLock::make(path("moved")).cause(), std::errc::file_exists);
  }
  EXPECT_TRUE(FileLock::wait_for(path("moved")).held());
  EXPECT_EQ(FileLock::take_existing(path("none")).answer(), LockAnswer::kNoFile);
}

}  // namespace
}  // namespace weftlight::platform
