#pragma once
// Another program of the display that has copied something, or is the clipboard manager, and answers or does not.

#include <memory>
#include <string>
#include <thread>

namespace weftlight::gui {

class SelectionOwner {
 public:
  enum class Answers { kNever, kAtOnce, kInPieces };
  /// Owns the selection when it returns: "CLIPBOARD", "CLIPBOARD_MANAGER". `text`: UTF-8.
  SelectionOwner(const std::string& display, const std::string& selection, Answers how, std::string text = {});
  ~SelectionOwner();
  SelectionOwner(const SelectionOwner&) = delete;
  SelectionOwner& operator=(const SelectionOwner&) = delete;
  bool is_owner() const { return owner_; }
  /// Whether another program has asked for what was copied.
  bool was_asked() const;

 private:
  struct Client;
  std::shared_ptr<Client> client_;
  bool owner_ = false;
  std::jthread thread_;
};

}  // namespace weftlight::gui
