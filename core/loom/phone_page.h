#pragma once
// The page for a phone or tablet at the loom: who may see it, what it shows, and which steps it asks for. Without any
// connection: requests in, answers out.
//
// The page is shown to browsers that were paired by a code, once each; then a random token in a cookie lets them in.
// Everything else that a browser's neighbour in the network, or a page of another site in the same browser, can try is
// refused: other names of this machine (DNS rebinding), posts that come from other pages, the page in a frame.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/page_request.h"

namespace weftlight::loom {

using platform::PageAnswer, platform::PageRequest;

/// What the page shows; texts are in the user's language.
struct PhoneShown {
  struct Color {
    std::string hex, text;  // "#7a1f3d"
    bool operator==(const Color&) const = default;
  };
  std::string title{}, heading{}, number{}, of{}, what{}, group{}, progress{};
  std::string remark{};         // what the weaver should know now
  std::vector<bool> shafts{};   // filled boxes, numbered from 1; none: no row of boxes
  std::vector<Color> colors{};  // of this step and of the next
  bool tabby = false, can_tabby = false;
  /// A PNG of the cloth so far; null: none is shown. Compared by its address.
  std::shared_ptr<const std::string> cloth{};
  bool operator==(const PhoneShown&) const = default;
};

enum class PhoneStep { kNext, kBack, kTabby };

class PhonePage {
 public:
  /// Fills bytes that nobody can guess; false if there are none.
  using RandomBytes = std::function<bool(std::span<uint8_t>)>;

  static constexpr int kMaxTries = 5;      // wrong codes until pairing closes
  static constexpr size_t kMaxPaired = 8;  // browsers
  static constexpr int kCodeDigits = 6;

  /// `host`: as browsers name the server, PageServer::host().
  PhonePage(std::string host, RandomBytes random);

  /// Six digits for the next browser; empty while pairing is closed.
  const std::string& code() const { return code_; }
  /// A new code; failed attempts are reset. Browsers that are paired stay so.
  void renew_code();
  size_t paired() const { return tokens_.size(); }
  /// Wrong codes since the last new one.
  int wrong_tries() const { return wrong_; }

  void show(PhoneShown shown);
  const PhoneShown& shown() const { return shown_; }
  /// Counts what was shown; a step names the one that it was asked from.
  uint64_t revision() const { return revision_; }

  /// Either an answer, or one that waits: for the step to be made, or for something new to show. Then answer_waiting
  /// answers the same request.
  struct Outcome {
    std::optional<PageAnswer> answer{};
    std::optional<PhoneStep> step{};
  };
  Outcome take(const PageRequest& request);
  PageAnswer answer_waiting(const PageRequest& request) const;

 private:
  Outcome get(const PageRequest& request) const;
  Outcome post(const PageRequest& request);
  PageAnswer pair(const PageRequest& request);
  bool is_paired(const PageRequest& request) const;
  /// `status` and its sentence, as a page.
  PageAnswer pairing_page(int status, const std::string& sentence) const;
  PageAnswer step_page(const std::string& sentence) const;
  PageAnswer state_answer() const;
  PageAnswer page(int status, const std::string& body) const;
  PageAnswer plain(int status, const std::string& sentence) const;

  std::string host_;
  RandomBytes random_;
  std::string code_;
  int wrong_ = 0;
  std::vector<std::string> tokens_;
  PhoneShown shown_;
  uint64_t revision_ = 1;
};

/// True if both are the same; takes as long where they differ early as where they differ late.
bool same_secret(const std::string& a, const std::string& b);

/// The page's style and script (phone_page_parts.cpp).
extern const char* const kPhoneStyle;
extern const char* const kPhoneScript;

}  // namespace weftlight::loom
