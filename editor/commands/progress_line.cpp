#include "commands/progress_line.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "base/json.h"
#include "base/text.h"

namespace weftlight::commands {
namespace {

using base::arg;
using base::fill;
using base::tr;

constexpr double kSecondsApart = 0.2;     // of two reports of one item
constexpr double kSecondsToEstimate = 1;  // of work, before the time left is told

double system_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string time_text(double seconds) {
  constexpr int kMinute = 60, kHour = 60;
  const auto whole = static_cast<int64_t>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
  if (whole < 2 * kMinute) return fill(tr("{seconds} s"), arg("seconds", whole));
  const int64_t minutes = (whole + kMinute - 1) / kMinute;
  if (minutes < 2 * kHour) return fill(tr("{minutes} min"), arg("minutes", minutes));
  return fill(tr("{hours} h {minutes} min"), arg("hours", minutes / kHour), arg("minutes", minutes % kHour));
}

namespace {

std::string progress_of_one(int percent, const std::string& left) {
  if (left.empty()) return fill(tr("{percent}%"), arg("percent", percent));
  return fill(tr("{percent}%, {time} left"), arg("percent", percent), arg("time", left));
}

std::string progress_of_many(const ProgressState& s, int percent, const std::string& left) {
  if (left.empty())
    return fill(tr("{done} of {count} done, {percent}%"), arg("done", s.done), arg("count", s.count),
                arg("percent", percent));
  return fill(tr("{done} of {count} done, {percent}%, {time} left"), arg("done", s.done), arg("count", s.count),
              arg("percent", percent), arg("time", left));
}

}  // namespace

std::string progress_text(const ProgressState& s) {
  const auto percent = static_cast<int>(100 * s.fraction);
  const std::string left = s.seconds_left ? time_text(*s.seconds_left) : "";
  const std::string text = s.count == 1 ? progress_of_one(percent, left) : progress_of_many(s, percent, left);
  return s.item.empty() ? text : fill(tr("{progress}: {item}"), arg("progress", text), arg("item", s.item));
}

std::string progress_json(const ProgressState& s) {
  nlohmann::json state{{"done", s.done},
                       {"count", s.count},
                       {"fraction", std::round(s.fraction * 1e4) / 1e4},
                       {"seconds_left", nullptr},
                       {"item", s.item}};
  if (s.seconds_left) state["seconds_left"] = std::round(*s.seconds_left * 10) / 10;
  return nlohmann::json{{"progress", state}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ProgressMeter::ProgressMeter(ProgressForm form, int count, std::function<double()> seconds)
    : form_(form),
      seconds_(seconds ? std::move(seconds) : system_seconds),
      fractions_(static_cast<size_t>(std::max(count, 1)), 0.0),
      skipped_(fractions_.size(), false) {
  started_ = seconds_();
}

ProgressState ProgressMeter::state() const {
  double work = 0, possible = 0, all = 0;
  ProgressState out{0, static_cast<int>(fractions_.size()), 0, {}, item_};
  for (size_t i = 0; i < fractions_.size(); ++i) {
    out.done += fractions_[i] >= 1, all += fractions_[i];
    if (!skipped_[i]) work += fractions_[i], possible += 1;
  }
  out.fraction = all / static_cast<double>(fractions_.size());
  const double spent = seconds_() - started_;
  if (work > 0 && spent >= kSecondsToEstimate) out.seconds_left = spent * (possible - work) / work;
  return out;
}

void ProgressMeter::set(int index, double fraction, const std::string& item) {
  fractions_[static_cast<size_t>(index)] = std::clamp(fraction, 0.0, 1.0);
  show(item);
}

void ProgressMeter::skip(int index, const std::string& item) {
  fractions_[static_cast<size_t>(index)] = 1, skipped_[static_cast<size_t>(index)] = true;
  show(item);
}

void ProgressMeter::show(const std::string& item) {
  if (form_ == ProgressForm::kNone) return;
  item_ = item;
  const ProgressState now = state();
  const double at = seconds_();
  if (now.done == last_done_ && shown_ >= 0 && at - shown_ < kSecondsApart) return;
  shown_ = at, last_done_ = now.done;
  if (form_ == ProgressForm::kJson) std::fprintf(stderr, "%s\n", progress_json(now).c_str());
  else line_.show(progress_text(now));
}

}  // namespace weftlight::commands
