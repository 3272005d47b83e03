// The gallery: its cards, its keyboard navigation, and the thumbnails.

#include "session/library/gallery.h"

#include <chrono>

#include "../scratch_fixture.h"
#include "base/whole_files.h"
#include "design/edits.h"
#include "paths.h"
#include "session/files/user_files.h"
#include "session/jobs/draft_thumbnails.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design;
using draft::Draft, draft::blank_draft;

namespace {

TEST(Gallery, CardsShowTheFolderOfTheirFile) {
  const auto cards = recent_cards({"/home/a/drafts/scarf.wif", "/home/abc/x.wif", "/home/a/y.wif"}, "/home/a/");
  ASSERT_EQ(cards.size(), 3u);
  EXPECT_EQ(cards[0].name, "scarf.wif");
  EXPECT_EQ(cards[0].where, "~/drafts");
  EXPECT_EQ(cards[1].where, "/home/abc");
  EXPECT_EQ(cards[2].where, "~");
  EXPECT_FALSE(cards[0].copy);
  EXPECT_EQ(recent_cards({"/a/x.wif"}, "")[0].where, "/a");
}

TEST(Gallery, TheLibraryHasEveryShippedDraftAndCloth) {
  const auto cards = library_cards();
  ASSERT_GT(cards.size(), 30u);
  EXPECT_EQ(cards.front().where, "Cloths");
  EXPECT_EQ(cards.back().where, "Drafts");
  for (const GalleryCard& card : cards) EXPECT_TRUE(card.copy) << card.name;
}

TEST(Gallery, EveryNameOfTheLibraryIsInTheCatalogueOfTexts) {
  const std::string catalogue = base::read_file(WEFTLIGHT_SOURCE_DIR "/editor/languages/weftlight.pot").value_or("");
  ASSERT_FALSE(catalogue.empty());
  for (const GalleryCard& card : library_cards())
    EXPECT_NE(catalogue.find("msgid \"" + card.name + "\""), std::string::npos) << card.name;
}

TEST(Gallery, SearchMatchesEveryTypedWord) {
  const auto cards = recent_cards({"/a/Scarf two.wif", "/b/scarf.wif", "/a/rug.wif"}, "");
  EXPECT_EQ(found_cards(cards, ""), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(found_cards(cards, "SCARF"), (std::vector<int>{0, 1}));
  EXPECT_EQ(found_cards(cards, "scarf /a"), (std::vector<int>{0}));
  EXPECT_TRUE(found_cards(cards, "silk").empty());
}

TEST(Gallery, ArrowKeysStopAtTheEdges) {
  EXPECT_EQ(stepped(-1, 5, 2, Step::kDown), 0) << "the first step chooses the first";
  EXPECT_EQ(stepped(0, 5, 2, Step::kDown), 2);
  EXPECT_EQ(stepped(3, 5, 2, Step::kDown), 4) << "into a last row that is not full";
  EXPECT_EQ(stepped(4, 5, 2, Step::kDown), 4);
  EXPECT_EQ(stepped(1, 5, 2, Step::kUp), 1);
  EXPECT_EQ(stepped(4, 5, 2, Step::kRight), 4);
  EXPECT_EQ(stepped(0, 5, 2, Step::kLeft), 0);
  EXPECT_EQ(stepped(3, 0, 2, Step::kLeft), -1);
}

TEST(Gallery, OpensAtTheStartOnlyWithoutAFile) {
  Settings s;
  EXPECT_FALSE(opens_with_gallery(s, false, false)) << "the tour comes first";
  s.toured = true;
  EXPECT_FALSE(opens_with_gallery(s, false, false)) << "nothing was open yet: the first draft and its cloth are seen";
  s.recent = {"towel.wif"};
  EXPECT_TRUE(opens_with_gallery(s, false, false));
  EXPECT_FALSE(opens_with_gallery(s, true, false));
  EXPECT_FALSE(opens_with_gallery(s, false, true));
  s.start_page = false;
  EXPECT_FALSE(opens_with_gallery(s, false, false));
  EXPECT_FALSE(settings_from(settings_text(s)).start_page);
}

TEST(Gallery, RecentFilesAreNewestFirstAndCanBeRemoved) {
  Settings s;
  for (int i = 0; i < 60; ++i) remember(s, "/drafts/" + std::to_string(i) + ".wif");
  EXPECT_EQ(s.recent.size(), 40u);
  EXPECT_EQ(s.recent.front(), "/drafts/59.wif");
  remember(s, "/drafts/50.wif");
  EXPECT_EQ(s.recent.front(), "/drafts/50.wif");
  forget(s, "/drafts/50.wif");
  EXPECT_EQ(s.recent.size(), 39u);
  EXPECT_EQ(s.recent.front(), "/drafts/59.wif");
}

/// Red warp over blue weft, plain.
Design plain(int ends = 2, int picks = 2) {
  Design d;
  d.draft = blank_draft(ends, picks, 2, 2);
  d.draft.palette = {{1, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < ends; ++i) d.draft.threading.set(i, i % 2, true);
  for (int i = 0; i < picks; ++i) d.draft.treadling.set(i, i % 2, true);
  for (int i = 0; i < 2; ++i) d.draft.tieup.set(i, i, true);
  return d;
}

TEST(Thumbnails, ShowTheDrawdownInItsColours) {
  const Thumbnail t = thumbnail_of(plain(), 384, 248);
  ASSERT_EQ(t.pixels.size(), 384u * 248u);
  const auto at = [&](int x, int y) { return t.pixels[static_cast<size_t>(y * 384 + x)] & 0xFFFFFF; };
  const auto red = [](uint32_t c) { return (c & 255) > 150 && (c >> 16) == 0; };
  const auto blue = [](uint32_t c) { return (c >> 16) > 150 && (c & 255) == 0; };
  EXPECT_TRUE(red(at(384 - 4, 4))) << "end 1 at the right, pick 1 on top";
  EXPECT_TRUE(blue(at(384 - 12, 4)));
  EXPECT_TRUE(blue(at(384 - 4, 12)));
  EXPECT_TRUE(red(at(384 - 12, 12)));
  EXPECT_TRUE(red(at(384 - 20, 4))) << "a small draft is repeated";
}

TEST(Thumbnails, ShowTheColoursAlongAThread) {
  Design d = plain();
  d.yarns[0].dye.stretches = {{1, draft::Rgb{0, 1, 0}, false}, {1, {}, false}};
  d.yarns.emplace_back();
  d.draft.weft.yarn.assign(d.draft.weft.yarn.size(), 1);
  const Thumbnail t = thumbnail_of(d, 384, 248);
  const auto at = [&](int x, int y) { return t.pixels[static_cast<size_t>(y * 384 + x)] & 0xFFFFFF; };
  EXPECT_GT(at(384 - 4, 4) >> 8 & 255, 150u) << "green at pick 1";
  EXPECT_EQ(at(384 - 4, 4) & 255, 0u);
  EXPECT_GT(at(384 - 12, 12) & 255, 150u) << "the thread's own red at pick 2";
}

TEST(Thumbnails, ALargeDraftShowsOneCrossingPerPixel) {
  const Thumbnail t = thumbnail_of(plain(9000, 7000), 384, 248);
  ASSERT_EQ(t.pixels.size(), 384u * 248u);
  int reds = 0, blues = 0;
  for (const uint32_t c : t.pixels) reds += static_cast<int>(c & 255), blues += static_cast<int>((c >> 16) & 255);
  EXPECT_NEAR(static_cast<double>(reds) / blues, 1, 0.1) << "half of each";
}

TEST(Thumbnails, WhiteDamaskShowsItsPattern) {
  Design d = plain();
  d.draft.palette = {{0.95f, 0.94f, 0.92f}, {0.96f, 0.95f, 0.93f}};
  const Thumbnail t = thumbnail_of(d, 384, 248);
  EXPECT_GT((t.pixels[384 - 4] & 255), (t.pixels[384 - 12] & 255) + 20);
}

TEST(Thumbnails, AnEmptyDraftHasNone) {
  EXPECT_TRUE(thumbnail_of(Design{}, 10, 10).pixels.empty());
  EXPECT_TRUE(thumbnail_of(plain(), 0, 10).pixels.empty());
}

class DraftThumbnailsTest : public ScratchTest {
 protected:
  static size_t files_in(const std::string& folder) {
    size_t n = 0;
    std::error_code error;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder, error)) ++n;
    return n;
  }
};

TEST_F(DraftThumbnailsTest, IsCachedUntilTheFileChanges) {
  const std::string cache = path("cache/drafts"), file = written("a.wif", wif::write_new_wif(plain()));
  const DraftThumbnail first = look_of_file(file, cache);
  EXPECT_EQ(first.state, DraftThumbnail::State::kThere);
  EXPECT_EQ(files_in(cache), 1u);
  EXPECT_GT(first.modified_ns, 0);
  EXPECT_EQ(look_of_file(file, cache).picture, first.picture) << "the kept one is the same to the bit";
  Design other = plain();
  other.draft.palette[0] = {0, 1, 0};
  written("a.wif", wif::write_new_wif(other));
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(5));
  EXPECT_NE(look_of_file(file, cache).picture, first.picture);
  EXPECT_EQ(files_in(cache), 2u);
}

TEST_F(DraftThumbnailsTest, ReportsMissingAndUnreadableFiles) {
  EXPECT_EQ(look_of_file(path("nowhere.wif"), path("cache")).state, DraftThumbnail::State::kMissing);
  EXPECT_EQ(look_of_file(written("b.wif", "no draft"), path("cache")).state, DraftThumbnail::State::kUnreadable);
  EXPECT_EQ(files_in(path("cache")), 0u);
}

TEST_F(DraftThumbnailsTest, WorksWithADamagedOrMissingCache) {
  const std::string file = written("a.wif", wif::write_new_wif(plain()));
  const DraftThumbnail there = look_of_file(file, written("in_the_way", "x") + "/drafts");
  EXPECT_EQ(there.state, DraftThumbnail::State::kThere);
  const std::string cache = path("cache");
  look_of_file(file, cache);
  for (const auto& entry : std::filesystem::directory_iterator(cache))
    EXPECT_EQ(problem_of(base::write_file_atomically(entry.path().string(), "no picture")), "");
  EXPECT_EQ(look_of_file(file, cache).picture, there.picture);
}

TEST_F(DraftThumbnailsTest, AreMadeInTheBackground) {
  const std::string file = written("a.wif", wif::write_new_wif(plain()));
  DraftThumbnails looks("", [] {});
  looks.ask(file);
  looks.ask(path("gone.wif"));
  std::vector<std::pair<std::string, DraftThumbnail>> made;
  for (int i = 0; i < 2000 && made.size() < 2; ++i) {
    for (auto& one : looks.take()) made.push_back(std::move(one));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made[0].first, file);
  EXPECT_EQ(made[0].second.state, DraftThumbnail::State::kThere);
  EXPECT_EQ(made[1].second.state, DraftThumbnail::State::kMissing);
}

}  // namespace
}  // namespace weftlight::session
