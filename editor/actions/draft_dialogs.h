#pragma once
// The dialogs that change the draft or move in it.

#include <functional>

namespace weftlight::actions {

struct DraftDialogs {
  std::function<void()> size, notes;
  /// Goes to an end or pick by its number.
  std::function<void()> go_to;
  /// Fills the selected threads, or all, with a weave.
  std::function<void()> weave;
  /// Threading and treadling from named sections.
  std::function<void()> sections;
  /// Asks for a picture and weaves it.
  std::function<void()> picture;
  /// Versions and colourways of the draft.
  std::function<void()> versions;
  /// Colours from one to another across threads.
  std::function<void()> gradient;
  /// Deletes the active colour or yarn. If threads have it, asks first, and says what takes its place.
  std::function<void()> delete_color, delete_yarn;
  /// Asks for another draft and joins this one with it.
  std::function<void()> join;
  /// Offers the closest weave to an edit that the loom cannot weave.
  std::function<void()> closest_weave;
};

}  // namespace weftlight::actions
