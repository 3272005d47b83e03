#include "app/messages.h"

#include <filesystem>
#include <utility>

#include "app/window.h"
#include "base/text.h"
#include "views/shell/status_bar.h"

namespace weftlight::app {

using base::arg, base::fill, base::tr;

namespace {

constexpr double kMessageS = 10;  // then hints replace it again

}  // namespace

void Messages::say(std::string text) {
  text_ = std::move(text);
  said_at_s_ = Window::seconds();
}

std::string Messages::text() const { return Window::seconds() - said_at_s_ < kMessageS ? text_ : std::string(); }

void Messages::report(std::vector<Diagnostic> remarks, const std::string& path) {
  remarks_ = std::move(remarks);
  remarks_open_ = true;
  say(fill(tr("{file} could not be opened"), arg("file", std::filesystem::path(path).filename().string())));
}

void Messages::follow(std::vector<Diagnostic> remarks) {
  remarks_ = std::move(remarks);
  remarks_open_ = remarks_open_ && !remarks_.empty();
}

void Messages::draw_remarks(PanelContext& c) { views::draw_remarks(c, remarks_, remarks_open_); }

}  // namespace weftlight::app
