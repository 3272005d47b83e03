#include "app/tabs.h"

#include <span>
#include <string>
#include <utility>

#include "app/fixed_window.h"
#include "base/text.h"
#include "session/tab_names.h"

namespace weftlight::app {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using session::Document, session::OpenDocument, session::Saver, session::loss_text, session::tab_name,
    session::tab_names;
using views::Question, views::draw_tab_strip;

void Tabs::step(int by) {
  session_.step(by);
  files_.look_at_file();
}

std::string Tabs::closing_question(uint64_t id) const {
  const OpenDocument* open = session_.find(id);
  const bool is_new = open != nullptr && open->document.path().empty();
  return fill(is_new ? tr("Save {draft}?") : tr("Save the changes to {draft}?"), arg("draft", tab_name(session_, id)));
}

void Tabs::close(uint64_t id, const std::function<void()>& then) {
  const auto closed = [this, id, then] {
    session_.close(id, Files::first_document);
    if (then) then();
  };
  const OpenDocument* open = session_.find(id);
  if (open == nullptr) return;
  if (Saver& saver = files_.saver(); saver.saving(id))
    return saver.after(id, [this, id, then] { dialogs_.when_none([this, id, then] { close(id, then); }); });
  if (open->document.is_saved()) return closed();
  session_.show(id);
  dialogs_.ask(Question{closing_question(id),
                        loss_text(session_, std::span(&id, 1)),
                        {mark("Save"), mark("Do not save"), mark("Cancel")}},
               [this, id, then, closed](int button) {
                 if (button == 1) closed();
                 // Again, since there may be edits meanwhile.
                 if (button == 0) files_.save_shown([this, id, then] { close(id, then); });
               });
}

void Tabs::close_each(std::vector<uint64_t> ids) {
  if (ids.empty()) return;
  const uint64_t id = ids.front();
  ids.erase(ids.begin());
  close(id, [this, ids] { close_each(ids); });
}

void Tabs::close_others() {
  std::vector<uint64_t> ids;
  for (const auto& open : session_.all())
    if (open->id != session_.active().id) ids.push_back(open->id);
  close_each(std::move(ids));
}

void Tabs::close_to_right() {
  std::vector<uint64_t> ids;
  for (size_t i = session_.active_place() + 1; i < session_.all().size(); ++i) ids.push_back(session_.all()[i]->id);
  close_each(std::move(ids));
}

void Tabs::quit() {
  if (Saver& saver = files_.saver(); saver.saving(0))
    return saver.after(0, [this] { dialogs_.when_none([this] { quit(); }); });
  const std::vector<uint64_t> unsaved = session_.unsaved();
  if (unsaved.empty()) {
    leaving_ = true;
    return;
  }
  if (unsaved.size() == 1) session_.show(unsaved.front());
  std::string names;
  for (const uint64_t id : unsaved) names += (names.empty() ? "" : ", ") + tab_name(session_, id);
  const bool one = unsaved.size() == 1;
  const std::string question =
      one ? closing_question(unsaved.front())
          : fill(tr_n("Save the changes to {count} draft?", "Save the changes to {count} drafts?",
                      static_cast<long long>(unsaved.size())),
                 arg("count", unsaved.size()));
  dialogs_.ask(Question{question,
                        (one ? "" : names + "\n\n") + loss_text(session_, unsaved),
                        {one ? mark("Save") : mark("Save all"), mark("Do not save"), mark("Cancel")}},
               [this, unsaved](int button) {
                 if (button == 1) leaving_ = true;
                 // Again, since there may be edits meanwhile.
                 if (button == 0) files_.save_each(unsaved, [this] { quit(); });
               });
}

std::string Tabs::shown_name() const { return tab_name(session_, session_.active().id); }

std::string Tabs::awaits() const {
  const Saver& saver = std::as_const(files_).saver();
  if (saver.awaited(0)) return tr("Weftlight closes when your drafts are saved\xE2\x80\xA6");
  if (saver.awaited(session_.active().id)) return tr("This tab closes when its draft is saved\xE2\x80\xA6");
  return {};
}

std::vector<Tab> Tabs::shown_tabs() const {
  std::vector<Tab> tabs;
  const std::vector<std::string> names = tab_names(session_);
  for (size_t i = 0; i < names.size(); ++i) {
    const Document& d = session_.all()[i]->document;
    tabs.push_back({session_.all()[i]->id, names[i], d.path().empty() ? tr("Not saved yet") : d.path(), !d.is_saved()});
  }
  return tabs;
}

TabRequest Tabs::draw(PanelContext& c, float height) {
  if (height <= 0) return {};
  const ImGuiViewport* view = ImGui::GetMainViewport();
  begin_fixed("Tabs", {view->WorkPos, {view->WorkSize.x, height}}, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  const TabRequest requested = draw_tab_strip(c, shown_tabs(), session_.active().id, strip_);
  ImGui::End();
  return requested;
}

void Tabs::carry_out(const TabRequest& requested) {
  if (requested.kind == TabRequest::Kind::kNone) return;
  schedule_.draw_after_event();
  if (requested.kind == TabRequest::Kind::kMove) return session_.move(requested.id, requested.place);
  if (requested.kind == TabRequest::Kind::kClose) return close(requested.id);
  strip_.menu_due = requested.kind == TabRequest::Kind::kMenu;
  if (requested.id == session_.active().id) return;
  session_.show(requested.id);
  files_.look_at_file();
}

TabActions Tabs::actions() {
  return {.count = [this] { return session_.all().size(); },
          .active = [this] { return session_.active_place(); },
          .step = [this](int by) { step(by); },
          .close = [this] { close(session_.active().id); },
          .close_others = [this] { close_others(); },
          .close_to_right = [this] { close_to_right(); }};
}

}  // namespace weftlight::app
