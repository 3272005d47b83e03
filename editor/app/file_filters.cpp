#include "app/file_filters.h"

#include "base/text.h"

namespace weftlight::app {

using base::tr;
using platform::FileAsk, platform::FileFilter;

std::vector<FileFilter> file_filters(FileAsk what, const std::string& ending) {
  if (what == FileAsk::kFolder) return {};
  if (ending == ".hdr") return {{tr("Environment maps"), "*.hdr *.HDR *.exr *.EXR"}, {tr("All files"), "*"}};
  if (ending == ".txt") return {{tr("Lists of yarns"), "*.txt *.TXT"}, {tr("All files"), "*"}};
  const FileFilter pictures{tr("Pictures, one pixel for each crossing"), "*.png *.PNG *.tif *.tiff *.TIF *.bmp"};
  if (what == FileAsk::kOpen && ending == kPictureEnding) return {pictures, {tr("All files"), "*"}};
  std::vector<FileFilter> filters;
  if (what == FileAsk::kOpen)
    filters.push_back({tr("Weaving drafts"), "*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO"});
  filters.push_back(ending == ".wif" ? FileFilter{tr("WIF drafts"), "*.wif *.WIF *.wifw *.WIFW"}
                                     : FileFilter{"*" + ending, "*" + ending});
  if (what == FileAsk::kOpen) filters.push_back(pictures);
  filters.push_back({tr("All files"), "*"});
  return filters;
}

}  // namespace weftlight::app
