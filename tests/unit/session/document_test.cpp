// Files of other formats become unnamed documents.

#include "session/document/document.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "files/files.h"

namespace weftlight::session {

using base::problem_of;

namespace {

TEST(Document, AnImageOpensAsADraftThatAsksForANameWhenSaved) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("weftlight-picture-" + std::to_string(getpid()) + ".png")).string();
  files::Image image{3, 2, 1, {0, 1, 1, 1, 0, 1}};
  ASSERT_EQ(problem_of(files::write_image(path, image, files::PixelType::kU8)), "");
  const OpenResult opened = open_document(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(opened.document);
  const Document& d = *opened.document;
  EXPECT_EQ(d.path(), "");
  EXPECT_TRUE(d.name().ends_with(".wif")) << d.name();
  EXPECT_EQ(d.now().draft.ends(), 3);
  EXPECT_TRUE(d.cells().get(0, 2)) << "the picture's left is the last end";
  EXPECT_TRUE(d.cells().get(1, 1));
  EXPECT_EQ(d.cells().count(), 2);
}

TEST(Document, ItsFilesAreCalledAsItsFileOrAfterItsTitle) {
  design::Design d;
  d.draft = draft::blank_draft(4, 4, 2, 2);
  EXPECT_EQ(Document(d).file_stem(), "untitled");
  d.title = "Shawl No. 3";
  Document document(d);
  EXPECT_EQ(document.file_stem(), "Shawl No. 3") << "a point in a title is no ending";
  document.without_file("scarf.wif");
  EXPECT_EQ(document.file_stem(), "scarf");
  d.title = " 2/2 twill: blue? ";
  EXPECT_EQ(Document(d).file_stem(), "2-2 twill- blue-");
  d.title = "../..";
  EXPECT_EQ(Document(d).file_stem(), "-");
  d.title = "...";
  EXPECT_EQ(Document(d).file_stem(), "untitled");
}

}  // namespace
}  // namespace weftlight::session
