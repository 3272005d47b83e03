#include "commands/option_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/text.h"
#include "base/utf8.h"
#include "design/lights.h"

namespace weftlight::commands {

using base::arg, base::as_utf8, base::cut_utf8, base::fill, base::tr;
using design::is_environment;
using draft::Face;

namespace {

constexpr double kMaxAngleDeg = 89.9;
constexpr size_t kMaxAngles = 10000;

std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find(between, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// False: a part is not a finite number.
bool parse_numbers(const std::vector<std::string>& parts, std::vector<double>& out) {
  for (const std::string& part : parts) {
    try {
      size_t used = 0;
      out.push_back(std::stod(part, &used));
      if (used != part.size() || !std::isfinite(out.back())) return false;
    } catch (const std::exception&) {
      return false;
    }
  }
  return true;
}

/// FROM:TO:STEP as the angles themselves.
std::string expand_range(const std::string& text, const std::vector<double>& range, std::vector<double>& out) {
  if (range.size() != 3 || range[2] <= 0 || range[1] < range[0])
    return fill(tr("'{text}' is not of the form FROM:TO:STEP, upwards"), arg("text", text));
  const double count = std::floor((range[1] - range[0]) / range[2] + 1e-9) + 1;
  if (count > static_cast<double>(kMaxAngles))
    return fill(tr("'{text}': too many angles; take a wider step"), arg("text", text));
  for (int k = 0; k < static_cast<int>(count); ++k) out.push_back(range[0] + k * range[2]);
  return {};
}

}  // namespace

std::string quoted(const std::string& text) {
  constexpr size_t kMaxBytes = 40;
  const std::string whole = as_utf8(text);
  const std::string head(cut_utf8(whole, kMaxBytes));
  return "'" + head + (head.size() < whole.size() ? "..." : "") + "'";
}

bool parse_pair(const std::string& text, char between, float& a, float& b) {
  const size_t at = text.find(between, 1);
  if (at == std::string::npos) return false;
  try {
    size_t used_a = 0, used_b = 0;
    a = std::stof(text.substr(0, at), &used_a);
    b = std::stof(text.substr(at + 1), &used_b);
    return used_a == at && used_b == text.size() - at - 1 && std::isfinite(a) && std::isfinite(b);
  } catch (const std::exception&) {
    return false;
  }
}

CLI::Validator pair_of(char between, const std::string& form) {
  return CLI::Validator(
      [between, form](const std::string& text) {
        float a = 0, b = 0;
        return parse_pair(text, between, a, b)
                   ? std::string{}
                   : fill(tr("{text} is not of the form {form}"), arg("text", quoted(text)), arg("form", form));
      },
      form);
}

CLI::Validator whole_number(int64_t low, int64_t high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        int64_t value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = read.ec == std::errc{} && read.ptr == text.data() + text.size();
        return good && value >= low && value <= high
                   ? std::string{}
                   : fill(tr("{text} is not a whole number from {low} to {high}"), arg("text", quoted(text)),
                          arg("low", low), arg("high", high));
      },
      std::to_string(low) + ".." + std::to_string(high));
}

CLI::Validator above_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        float value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = read.ec == std::errc{} && read.ptr == text.data() + text.size() && std::isfinite(value);
        return good && value > 0 ? std::string{}
                                 : fill(tr("{text} is not a number greater than 0"), arg("text", quoted(text)));
      },
      "> 0");
}

CLI::Validator some_path() {
  return CLI::Validator(
      [](const std::string& text) -> std::string { return text.empty() ? tr("the name is empty") : ""; }, "PATH");
}

std::string parse_angles(const std::string& text, std::vector<double>& out) {
  out.clear();
  const bool range = text.find(':') != std::string::npos;
  std::vector<double> numbers;
  if (!parse_numbers(split(text, range ? ':' : ','), numbers))
    return fill(tr("'{text}' is not a list of angles"), arg("text", text));
  if (!range) out = numbers;
  else if (std::string wrong = expand_range(text, numbers, out); !wrong.empty()) return wrong;
  if (out.size() > kMaxAngles) return fill(tr("'{text}': too many angles"), arg("text", text));
  const bool inside = std::all_of(out.begin(), out.end(), [](double a) { return std::abs(a) <= kMaxAngleDeg; });
  return inside ? std::string{}
                : fill(tr("'{text}': angles lie between {low} and {high} degrees"), arg("text", text),
                       arg("low", -kMaxAngleDeg), arg("high", kMaxAngleDeg));
}

CLI::Validator angles_into(std::vector<double>& out) {
  return CLI::Validator([&out](const std::string& text) { return parse_angles(text, out); }, "A,B,..|FROM:TO:STEP");
}

bool parse_exposure(const std::string& text, bool& automatic, float& stops) {
  constexpr float kMaxStops = 20;
  constexpr std::string_view kAuto = "auto";
  automatic = text.starts_with(kAuto);
  stops = 0;
  std::string_view number(text);
  if (automatic) {
    number.remove_prefix(kAuto.size());
    if (number.empty()) return true;
    if (number[0] != '+' && number[0] != '-') return false;
  }
  if (number.starts_with('+')) number.remove_prefix(1);
  const auto read = std::from_chars(number.data(), number.data() + number.size(), stops);
  return read.ec == std::errc{} && read.ptr == number.data() + number.size() && std::abs(stops) <= kMaxStops;
}

CLI::Validator exposure_form() {
  return CLI::Validator(
      [](const std::string& text) {
        bool automatic = false;
        float stops = 0;
        return parse_exposure(text, automatic, stops)
                   ? std::string{}
                   : fill(tr("{text} is not an exposure; give stops from -20 to 20, auto, or auto+EV"),
                          arg("text", quoted(text)));
      },
      "EV|auto|auto+EV");
}

CLI::Validator environment_file() {
  return CLI::Validator(
      [](const std::string& text) {
        return is_environment(text) ? std::string{}
                                    : fill(tr("{text} is neither an .hdr nor an .exr"), arg("text", quoted(text)));
      },
      "FILE.hdr|FILE.exr");
}

void add_face(CLI::App& verb, Face& face) {
  verb.add_option_function<std::string>(
          "--face", [&face](const std::string& name) { face = name == "back" ? Face::kBack : Face::kFront; },
          tr("Face of the cloth; default: front"))
      ->check(CLI::IsMember({"front", "back"}));
}

}  // namespace weftlight::commands
