#include "commands/option_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
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

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return {};
  if (!std::isfinite(static_cast<float>(value))) return {};  // options hold floats
  return value;
}

/// Without an exponent, unless it is very large.
std::string plain_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string out_of_range(const std::string& text, double low, double high) {
  return fill(tr("{text} is not a number from {low} to {high}"), arg("text", quoted(text)),
              arg("low", plain_number(low)), arg("high", plain_number(high)));
}

base::Failure not_angles(std::string why) { return base::failure(base::ErrorKind::kUsage, std::move(why)); }

/// FROM:TO:STEP as the angles themselves.
base::Result<std::vector<double>> expand_range(const std::string& text, const std::vector<double>& range) {
  if (range.size() != 3 || range[2] <= 0 || range[1] < range[0])
    return not_angles(fill(tr("'{text}' is not of the form FROM:TO:STEP, upwards"), arg("text", text)));
  const double count = std::floor((range[1] - range[0]) / range[2] + 1e-9) + 1;
  if (count > static_cast<double>(kMaxAngles))
    return not_angles(fill(tr("'{text}': too many angles; take a wider step"), arg("text", text)));
  std::vector<double> angles;
  for (int k = 0; k < static_cast<int>(count); ++k) angles.push_back(range[0] + k * range[2]);
  return angles;
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

CLI::Validator pair_of(char between, const std::string& form, Limits first, Limits second) {
  return CLI::Validator(
      [=](const std::string& text) {
        float a = 0, b = 0;
        if (!parse_pair(text, between, a, b))
          return fill(tr("{text} is not of the form {form}"), arg("text", quoted(text)), arg("form", form));
        for (const auto& [value, limits] : {std::pair{a, first}, {b, second}})
          if (value < limits.low || value > limits.high)
            return out_of_range(plain_number(value), limits.low, limits.high);
        return std::string();
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

CLI::Validator number_in(double low, double high) {
  return CLI::Validator(
      [=](const std::string& text) {
        const std::optional<double> value = number_of(text);
        return value && *value >= low && *value <= high ? std::string() : out_of_range(text, low, high);
      },
      plain_number(low) + ".." + plain_number(high));
}

CLI::Validator above_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::optional<double> value = number_of(text);
        return value && static_cast<float>(*value) > 0
                   ? std::string{}
                   : fill(tr("{text} is not a number greater than 0"), arg("text", quoted(text)));
      },
      "X");
}

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string form = CLI::detail::join(words, "|");
  return CLI::Validator(
      [words = std::move(words)](const std::string& text) {
        return std::ranges::find(words, text) != words.end()
                   ? std::string{}
                   : fill(tr("{text} must be one of {words}"), arg("text", quoted(text)),
                          arg("words", CLI::detail::join(words, ", ")));
      },
      form);
}

CLI::Validator one_of_numbers(std::vector<double> numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(plain_number(number));
  const std::string form = CLI::detail::join(words, "|");
  return CLI::Validator(
      [numbers = std::move(numbers), words = std::move(words)](const std::string& text) {
        const std::optional<double> value = number_of(text);
        return value && std::ranges::find(numbers, *value) != numbers.end()
                   ? std::string{}
                   : fill(tr("{text} must be one of {words}"), arg("text", quoted(text)),
                          arg("words", CLI::detail::join(words, ", ")));
      },
      form);
}

CLI::Validator some_path(const char* form) {
  return CLI::Validator(
      [](const std::string& text) -> std::string { return text.empty() ? tr("the name is empty") : ""; }, tr(form));
}

base::Result<std::vector<double>> parse_angles(const std::string& text) {
  const bool range = text.find(':') != std::string::npos;
  std::vector<double> numbers;
  if (!parse_numbers(split(text, range ? ':' : ','), numbers))
    return not_angles(fill(tr("'{text}' is not a list of angles"), arg("text", text)));
  base::Result<std::vector<double>> angles = range ? expand_range(text, numbers) : numbers;
  if (!angles) return angles;
  if (angles->size() > kMaxAngles) return not_angles(fill(tr("'{text}': too many angles"), arg("text", text)));
  if (std::ranges::any_of(*angles, [](double a) { return std::abs(a) > kMaxAngleDeg; }))
    return not_angles(fill(tr("'{text}': angles lie between {low} and {high} degrees"), arg("text", text),
                           arg("low", -kMaxAngleDeg), arg("high", kMaxAngleDeg)));
  return angles;
}

CLI::Validator angles_into(std::vector<double>& out) {
  return CLI::Validator(
      [&out](const std::string& text) {
        base::Result<std::vector<double>> angles = parse_angles(text);
        if (angles) out = *angles;
        return problem_of(angles);
      },
      "A,B,..|FROM:TO:STEP");
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

void add_progress(CLI::App& verb, bool& quiet, bool& json) {
  auto* silent = verb.add_flag("--quiet", quiet, tr("No progress and no list of what was written; problems only"));
  verb.add_option_function<std::string>(
          "--progress", [&json](const std::string& form) { json = form == "json"; },
          tr("Progress on stderr: auto is a line on a terminal, json one line of JSON for each report; default: auto"))
      ->check(one_of({"auto", "json"}))
      ->excludes(silent);
}

void add_face(CLI::App& verb, Face& face) {
  verb.add_option_function<std::string>(
          "--face", [&face](const std::string& name) { face = name == "back" ? Face::kBack : Face::kFront; },
          tr("Face of the cloth; default: front"))
      ->check(one_of({"front", "back"}));
}

}  // namespace weftlight::commands
