#include "app/messages.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
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

void Messages::keep_unopened() {
  if (!remarks_open_) {
    unopened_.clear();
    about_unopened_ = 0;
  }
  remarks_.resize(about_unopened_);
}

void Messages::report(std::vector<Diagnostic> remarks, const std::string& path) {
  keep_unopened();
  const std::string file = std::filesystem::path(path).filename().string();
  for (Diagnostic& d : remarks) {
    if (d.text.find(file) == std::string::npos) d.text = file + ": " + d.text;
    remarks_.push_back(std::move(d));
  }
  about_unopened_ = remarks_.size();
  if (std::ranges::find(unopened_, file) == unopened_.end()) unopened_.push_back(file);
  remarks_open_ = true;
  std::string files;
  for (const std::string& each : unopened_) files += (files.empty() ? "" : ", ") + each;
  refuse(fill(tr("{file} could not be opened"), arg("file", files)));
}

void Messages::follow(std::vector<Diagnostic> remarks) {
  keep_unopened();
  std::ranges::move(remarks, std::back_inserter(remarks_));
  remarks_open_ = remarks_open_ && !remarks_.empty();
}

void Messages::draw_remarks(PanelContext& c) { views::draw_remarks(c, remarks_, remarks_open_); }

}  // namespace weftlight::app
