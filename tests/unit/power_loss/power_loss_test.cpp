// Whenever the power fails, a file is the old one or the new one, a journal gives every stroke up to the last that was
// synced, and what was reported as done is there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "../scratch_fixture.h"
#include "../straight_draft.h"
#include "design/edits.h"
#include "disk.h"
#include "session/document/document.h"
#include "session/files/own_output.h"
#include "session/files/user_files.h"
#include "session/recovery/journal.h"
#include "session/recovery/recovery.h"
#include "session/session.h"
#include "texture_set/set_folder.h"
#include "texture_set/targets.h"
#include "texture_set/texture_set.h"
#include "wif/wif.h"

namespace weftlight {
namespace {

namespace fs = std::filesystem;

class PowerLoss : public ScratchTest {
 protected:
  /// The texts of the crashed sessions' work.
  std::vector<std::string> left() const {
    session::Recovery recovery(path("state/weftlight/recovery"));
    std::vector<std::string> texts;
    for (const session::LeftWork& one : recovery.left_behind()) {
      if (const auto entry = read_left(one)) texts.push_back(entry->text);
    }
    return texts;
  }
  std::string recovery_folder() const { return path("state/weftlight/recovery"); }
};

TEST_F(PowerLoss, AFileIsTheOldOneOrTheNew) {
  const std::vector<std::string> texts{"the first", "the second, which is longer", "3", ""};
  written("a.wif", texts[0]);
  Disk disk(dir_);
  for (int i = 1; i < 4; ++i) {
    ASSERT_TRUE(base::write_file_atomically(path("a.wif"), texts[static_cast<size_t>(i)]));
    disk.promise(i);
  }
  const size_t crashes = disk.after_each_crash([&](int promised) {
    const std::string now = base::read_file(path("a.wif")).value_or("");
    const auto found = std::ranges::find(texts, now);
    ASSERT_NE(found, texts.end()) << now;
    EXPECT_GE(found - texts.begin(), promised);
    EXPECT_LE(found - texts.begin(), promised + 1);
  });
  EXPECT_GT(crashes, 10u);
}

TEST_F(PowerLoss, TheJournalGivesEveryStrokeThatWasSynced) {
  constexpr int kStrokes = 6;
  const auto text = [](int stroke) { return "[WIF]\n" + std::string(static_cast<size_t>(300 + stroke), 'a' + stroke); };
  Disk disk(dir_);
  {
    session::Recovery recovery(recovery_folder());
    session::Journal journal(recovery);
    for (int stroke = 1; stroke <= kStrokes; ++stroke) {
      // A new name begins the journal anew.
      journal.keep(1, {"", stroke < 5 ? "a" : "b", {}}, [&, stroke] { return text(stroke); });
      journal.settle();
      ASSERT_EQ(journal.problem(), "");
      disk.promise(stroke);
    }
  }
  const size_t crashes = disk.after_each_crash([&](int promised) {
    const std::vector<std::string> found = left();
    int newest = 0;
    for (const std::string& one : found)
      for (int stroke = 1; stroke <= kStrokes; ++stroke)
        if (one == text(stroke)) newest = std::max(newest, stroke);
    EXPECT_GE(newest, promised) << found.size() << " offered";
    EXPECT_LE(found.size(), 1u);
  });
  EXPECT_GT(crashes, 20u);
}

TEST_F(PowerLoss, EveryStrokeIsInTheFileOrInTheJournal) {
  std::vector<std::string> texts;
  std::vector<design::Design> designs{straight_draft(4)};
  written("a.wif", wif::write_new_wif(designs[0]));
  fs::create_directories(recovery_folder());
  Disk disk(dir_);
  {
    session::Session session(recovery_folder(), session::Document(designs[0]));
    wif::WifRead read = wif::read_wif(base::read_file(path("a.wif")).value_or(""));
    const uint64_t id =
        session
            .add(session::Document(std::move(*read.file), {}, path("a.wif"), session::identify(path("a.wif"))),
                 session::Origin::kOwn)
            .id;
    texts.push_back(session.active().document.writer()());
    for (int stroke = 1; stroke <= 6; ++stroke) {
      const int end = stroke % 4, shaft = stroke % 3;
      session.commit(
          {"paint", [=](const design::Design& d) { return design::with_threading(d, end, shaft, stroke % 2 == 0); }},
          static_cast<uint64_t>(stroke));
      texts.push_back(session.active().document.writer()());
      session.settle();
      disk.promise(stroke);
      if (stroke % 3 != 0) continue;
      const session::SaveJob job = session.save_job(id, path("a.wif"));
      session.take_saved(job, session::write(job));
      session.settle();
      disk.promise(stroke);
    }
  }
  disk.after_each_crash([&](int promised) {
    const auto stage = [&](const std::string& text) {
      return static_cast<int>(std::find(texts.rbegin(), texts.rend(), text) == texts.rend()
                                  ? -1
                                  : texts.rend() - std::find(texts.rbegin(), texts.rend(), text) - 1);
    };
    const int in_file = stage(base::read_file(path("a.wif")).value_or(""));
    int in_journal = 0;
    for (const std::string& one : left()) in_journal = std::max(in_journal, stage(one));
    EXPECT_TRUE(in_file >= 0 || base::read_file(path("a.wif")).value_or("") == wif::write_new_wif(designs[0]));
    EXPECT_GE(std::max(in_file, in_journal), promised);
  });
}

TEST_F(PowerLoss, SettingsAreTheOldOnesOrTheNew) {
  ::setenv("XDG_CONFIG_HOME", path("config").c_str(), 1);
  fs::create_directories(path("config/weftlight"));
  session::Settings old, now;
  old.heavy_lines = 4, now.heavy_lines = 8;
  session::save_settings(old);
  Disk disk(dir_);
  session::save_settings(now);
  disk.promise(1);
  disk.after_each_crash([&](int promised) {
    const int lines = session::load_settings().heavy_lines;
    EXPECT_TRUE(lines == 8 || (lines == 4 && promised == 0)) << lines;
  });
}

TEST_F(PowerLoss, TheLiveExportKnowsItsFile) {
  fs::create_directories(path("state"));
  Disk disk(dir_);
  {
    session::LiveExport live(path("live.wif"), path("state"));
    for (int i = 1; i <= 3; ++i) {
      ASSERT_TRUE(live.write("text " + std::to_string(i)));
      disk.promise(i);
    }
  }
  disk.after_each_crash([&](int promised) {
    const std::string now = base::read_file(path("live.wif")).value_or("");
    EXPECT_TRUE(now.empty() ? promised == 0 : now >= "text " + std::to_string(promised)) << now;
    EXPECT_EQ(base::problem_of(session::LiveExport(path("live.wif"), path("state")).check({})), "") << now;
  });
}

std::map<std::string, std::string> bytes_in(const fs::path& folder) {
  std::map<std::string, std::string> all;
  if (!fs::exists(folder)) return all;
  for (const auto& entry : fs::directory_iterator(folder))
    all[entry.path().filename().string()] = base::read_file(entry.path().string()).value_or("");
  return all;
}

TEST_F(PowerLoss, AnExportedSetHasWholeFilesAndStaysItsOwners) {
  texture_set::TextureSetOptions options;
  options.target = &texture_set::targets::kGodot;
  options.name = "x", options.size = 16, options.draft_path = options.source = "x.wif";
  const design::Design before = straight_draft(4), after = design::with_palette_color(before, 0, {0.9f, 0.1f, 0.2f});
  const Scratch whole("whole");
  ASSERT_TRUE(texture_set::write_texture_set(whole / "old", before, {}, options));
  ASSERT_TRUE(texture_set::write_texture_set(whole / "new", after, {}, options));
  const auto old_set = bytes_in(whole / "old"), new_set = bytes_in(whole / "new");
  const texture_set::SetIdentity identity{texture_set::draft_from(path("set"), "x.wif"), "x.wif", "godot"};
  Disk disk(dir_);
  ASSERT_TRUE(texture_set::write_texture_set(path("set"), before, {}, options));
  disk.promise(1);
  ASSERT_TRUE(texture_set::write_texture_set(path("set"), after, {}, options));
  disk.promise(2);
  disk.after_each_crash([&](int promised) {
    const auto now = bytes_in(path("set"));
    EXPECT_EQ(base::problem_of(texture_set::check_place(path("set"), identity)), "");
    if (promised == 0) {
      EXPECT_TRUE(now.empty() || now == old_set);
      return;
    }
    for (const auto& [name, bytes] : old_set) EXPECT_TRUE(now.contains(name)) << name;
    for (const auto& [name, bytes] : now) {
      if (name == "texture_set.json") continue;                // for a while it lists the files of both
      if (name.find(".part-") != std::string::npos) continue;  // of a write that was cut off: nothing reads it
      EXPECT_TRUE((old_set.contains(name) && bytes == old_set.at(name)) ||
                  (new_set.contains(name) && bytes == new_set.at(name)))
          << name << ", " << bytes.size() << " bytes";
    }
    if (promised == 2) {
      EXPECT_EQ(now, new_set);
    }
  });
}

}  // namespace
}  // namespace weftlight
