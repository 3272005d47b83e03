#pragma once
// How the rows of the table of actions are written; for the files that fill it.

#include <functional>
#include <utility>
#include <vector>

#include "app/actions.h"
#include "app/names.h"

namespace weftlight::app {

using Actions = std::vector<Action>;

inline Action& add(Actions& all, const char* menu, const char* id, const char* label, const char* shortcut,
                   std::function<void(Editor&)> run) {
  Action& a = all.emplace_back();
  a.item.id = id;
  a.item.menu = menu;
  a.item.label = label;
  a.item.shortcut = shortcut;
  a.run = std::move(run);
  return a;
}

inline Action& with_icon(Action& a, const char* icon) {
  a.item.icon = icon;
  return a;
}

inline Action& new_group(Action& a) {
  a.item.group = true;
  return a;
}

/// What is done with the selection: clipboard, moves, turns, repeats, whole threads, and the tools.
void add_selection_actions(Actions& all);
/// Choosing ends and picks for the Threads panel, and its rows (thread_actions.cpp).
void add_thread_actions(Actions& all);

}  // namespace weftlight::app
