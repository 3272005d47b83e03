#include "app/loom_window.h"

#include <memory>

#include "app/fixed_window.h"
#include "app/window.h"
#include "base/text.h"
#include "draft/drawdown.h"
#include "draft/hex_color.h"
#include "loom/tabby.h"
#include "session/loom/cloth_so_far.h"
#include "views/loom/loom_panel.h"

namespace weftlight::app {

using base::arg, base::fill, base::tr;
using draft::lifts;
using loom::PhoneShown, loom::PhoneStep;
using session::cloth_so_far_png, session::greet, session::hear, session::loom_groups, session::place_of,
    session::shown_step, session::step_by_hand, session::words_of;
using views::draw_loom;

LoomWindow::LoomWindow(Session& session, Editing& editing, const Settings& settings)
    : session_(session), editing_(editing), settings_(settings), link_(Window::wake), phone_(Window::wake) {}

void LoomWindow::toggle() {
  AtLoom& at = at_loom();
  at.open = !at.open;
  address_ = settings_.loom_address;
  page_error_.clear();
  if (at.open) {
    addresses_ = platform::own_addresses();
  } else {
    link_.disconnect();
    phone_.close();
  }
}

void LoomWindow::step(bool forwards) {
  carry_out(step_by_hand(at_loom(), editing_.document().now(), forwards, connected()));
}

void LoomWindow::give_tabby() { carry_out(session::give_tabby(at_loom(), editing_.document().now(), connected())); }

void LoomWindow::put_tabby_between() {
  const session::Design& design = editing_.document().now();
  carry_out(session::put_tabby_between(at_loom(), design, !design.loom.tabby_between));
}

void LoomWindow::connect() {
  weaves_ = session_.active().id;
  link_.connect(settings_.loom_address, at_loom().protocol);
}

void LoomWindow::open_page() {
  page_of_ = session_.active().id;
  const base::Result<void> opened = phone_.open(page_address_);
  page_error_ = opened ? std::string() : base::problem_of(opened);
  Window::wake();  // the next frame shows what became of it
}

void LoomWindow::carry_out(const LoomStep& step) {
  if (!step.send.empty()) link_.send(step.send);
  if (step.edit) editing_.commit(*step.edit);
}

bool LoomWindow::update() {
  const bool linked = update_link();
  const bool paged = update_page();
  say_new_step();
  return paged || linked;
}

void LoomWindow::say_new_step() {
  if (!at_loom().open || !settings_.say_steps) return said_.clear();
  if (std::string words = words_of(shown()); words != said_) {
    if (!said_.empty()) speaker_.say(words);
    said_ = std::move(words);
  }
}

void LoomWindow::say_step() {
  if (speaker_.is_there()) return speaker_.say(words_of(shown()));
  at_loom().remark = tr("No speech program was found; install espeak-ng or speech-dispatcher");
}

bool LoomWindow::update_link() {
  // The loom weaves the draft that it was connected with: another active draft disconnects it.
  if (state_ != LoomLink::State::kOff && weaves_ != session_.active().id) link_.disconnect();
  const LoomLink::Received received = link_.take();
  if (received.connected) carry_out(greet(at_loom(), editing_.document().now()));
  for (const loom::LoomReport& report : received.reports) carry_out(hear(at_loom(), editing_.document().now(), report));
  if (const std::string unsent = std::exchange(at_loom().to_send, {}); !unsent.empty() && connected())
    link_.send(unsent);
  const LoomLink::State state = link_.state();
  std::string why = link_.why();
  const bool other = state != state_ || why != why_;
  state_ = state;
  why_ = std::move(why);
  return other || received.connected || !received.reports.empty();
}

bool LoomWindow::update_page() {
  // The page shows the draft that it was opened with.
  if (page_.open && page_of_ != session_.active().id) phone_.close();
  const std::vector<PhoneStep> steps = phone_.take_steps();
  for (const PhoneStep one : steps) {
    if (one == PhoneStep::kTabby) give_tabby();
    else step(one == PhoneStep::kNext);
  }
  PhoneLink::Status status = phone_.status();
  const bool other = status != page_;
  page_ = std::move(status);
  if (page_.open) show_on_page();
  return other || !steps.empty();
}

ShownStep LoomWindow::shown() {
  const session::Design& design = editing_.document().now();
  if (!groups_ || counted_revision_ != session_.revision()) {
    groups_ = loom_groups(design);
    lifts_ = lifts(design.draft);
    counted_revision_ = session_.revision();
  }
  return shown_step(at_loom(), design, lifts_, *groups_);
}

void LoomWindow::show_on_page() {
  const session::Design& design = editing_.document().now();
  const AtLoom& at = at_loom();
  const ShownStep step = shown();
  PhoneShown page;
  page.title = design.title;
  page.heading = step.heading;
  if (!step.done()) {
    page.number = std::to_string(step.number);
    page.of = fill(tr("of {count}"), arg("count", step.of));
  }
  page.what = step.what;
  page.group = step.group;
  page.progress = step.progress;
  page.remark = at.remark;
  page.shafts = step.shafts;
  for (const auto* color : {&step.color, &step.next_color})
    if (*color) page.colors.push_back({hex_of((*color)->color), (*color)->text});
  page.tabby = step.tabby;
  if (step.work == LoomWork::kWeave) {
    page.can_tabby = loom::tabby_sheds(design.draft).has_value();
    const std::pair now(session_.revision(), place_of(at, design));
    if (pictured_ != now) {
      picture_ = std::make_shared<const std::string>(cloth_so_far_png(at, design, editing_.document().cells()));
      pictured_ = now;
    }
    if (!picture_->empty()) page.cloth = picture_;
  }
  phone_.show(std::move(page));
}

void LoomWindow::draw(PanelContext& c, const WindowLayout& l) {
  begin_fixed("Loom", {l.draft.at, {l.status.size.x, l.draft.size.y}}, {0, 0}, kFixed);
  draw_loom(c, {at_loom(), shown(), {state_, why_}, page_, page_error_, addresses_, speaker_.is_there()}, address_,
            page_address_);
  ImGui::End();
}

LoomActions LoomWindow::actions() {
  return {.toggle = [this] { toggle(); },
          .step = [this](bool forwards) { step(forwards); },
          .tabby = [this] { give_tabby(); },
          .tabby_between = [this] { put_tabby_between(); },
          .say = [this] { say_step(); },
          .work = [this](LoomWork work) { at_loom().work = work; },
          .connect = [this] { connect(); },
          .disconnect = [this] { disconnect(); },
          .open_page = [this] { open_page(); },
          .close_page =
              [this] {
                phone_.close();
                Window::wake();
              },
          .renew_code =
              [this] {
                phone_.renew_code();
                Window::wake();
              },
          .serves_page = [this] { return page_.open; }};
}

}  // namespace weftlight::app
