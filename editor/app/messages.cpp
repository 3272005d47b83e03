#include "app/messages.h"

#include <filesystem>
#include <utility>

#include "base/text.h"

namespace weftlight::app {

using base::arg, base::fill, base::tr;

namespace {

constexpr double kReadingS = 4;  // shown at least that long

}  // namespace

void Messages::show(StatusMessage message) {
  shown_ = std::move(message);
  said_at_s_ = seconds_();
}

void Messages::begin_action() {
  if (seconds_() - said_at_s_ >= kReadingS) clear();
}

void Messages::report(std::vector<Diagnostic> remarks, const std::string& path) {
  remarks_ = std::move(remarks);
  remarks_open_ = true;
  refuse(fill(tr("{file} could not be opened"), arg("file", std::filesystem::path(path).filename().string())));
}

void Messages::follow(std::vector<Diagnostic> remarks) {
  remarks_ = std::move(remarks);
  remarks_open_ = remarks_open_ && !remarks_.empty();
}

void Messages::draw_remarks(PanelContext& c) { views::draw_remarks(c, remarks_, remarks_open_); }

}  // namespace weftlight::app
