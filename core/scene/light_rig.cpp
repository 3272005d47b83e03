// Based on: Ramamoorthi, Hanrahan 2001, "An efficient representation for irradiance environment maps".

#include "scene/light_rig.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <vector>

#include "base/json.h"
#include "base/text.h"

namespace weftlight::scene {

using base::arg, base::fill, base::tr;

namespace {

struct Lamp {
  glm::vec3 towards{0, 1, 0}, color{1};
  float sharpness = 1;  // of exp(sharpness (cos - 1)); 1 fills half the sky, 20 is a soft box
};

Harmonics project(const std::vector<Lamp>& lamps) {
  Harmonics sum{};
  constexpr int kSamples = 8192;  // a spiral over the sphere: enough for lamps of sharpness 60
  for (int i = 0; i < kSamples; ++i) {
    const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / kSamples;
    const float a = 2.39996323f * static_cast<float>(i), r = std::sqrt(std::max(0.0f, 1 - y * y));
    const glm::vec3 d{r * std::cos(a), y, r * std::sin(a)};
    glm::vec3 radiance{0};
    for (const Lamp& lamp : lamps) radiance += lamp.color * std::exp(lamp.sharpness * (glm::dot(d, lamp.towards) - 1));
    const std::array<float, 9> basis = harmonics(d);
    for (size_t k = 0; k < 9; ++k) sum[k] += radiance * (basis[k] * 4 * 3.14159265f / kSamples);
  }
  return sum;
}

/// Iterates over a text and counts its lines, since the parser does not report line numbers.
struct LineCounter {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  int* line;
  reference operator*() const { return *at; }
  LineCounter& operator++() {
    *line += *at++ == '\n';
    return *this;
  }
  LineCounter operator++(int) {
    const LineCounter before = *this;
    ++*this;
    return before;
  }
  bool operator==(const LineCounter& other) const { return at == other.at; }
  bool operator!=(const LineCounter& other) const { return at != other.at; }
};

/// Line numbers of the parts of a preset.
struct Lines {
  int now = 1;
  std::map<std::string, int> keys;  // of the top level
  std::vector<int> lamps;
};

using nlohmann::json;

/// An invalid value; caught where the file is read.
struct InvalidValue {
  std::string what;
};

/// Before a value takes memory; the callback of parse() takes a time that grows with the square of a list of objects.
void check_extent(std::string_view text) {
  constexpr size_t kMaxValues = 10'000;
  const base::JsonExtent extent = base::json_extent(text);
  if (extent.depth > base::kMaxJsonDepth)
    throw InvalidValue{fill(tr("its JSON is nested deeper than {most}"), arg("most", int{base::kMaxJsonDepth}))};
  if (extent.values > kMaxValues)
    throw InvalidValue{
        fill(tr("has {count} values; at most {most} are read"), arg("count", extent.values), arg("most", kMaxValues))};
}

json parse(std::string_view text, Lines& lines) {
  check_extent(text);
  std::string key;
  const auto note = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::key && depth == 1) lines.keys[key = value.get<std::string>()] = lines.now;
    if (event == json::parse_event_t::object_start && depth == 2 && key == "lamps") lines.lamps.push_back(lines.now);
    return true;
  };
  const char* end = text.data() + text.size();
  return json::parse(LineCounter{text.data(), &lines.now}, LineCounter{end, &lines.now}, note);
}

InvalidValue missing(const char* name) { return {fill(tr("{name} is missing"), arg("name", name))}; }

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

float number(const json& value, const std::string& name, float low, float high) {
  if (!value.is_number()) throw InvalidValue{fill(tr("{name} is not a number"), arg("name", name))};
  const double v = value.get<double>();
  if (!(v >= static_cast<double>(low) && v <= static_cast<double>(high)))
    throw InvalidValue{fill(tr("{name} is {value}; give {low} to {high}"), arg("name", name),
                            arg("value", number_text(v)), arg("low", number_text(static_cast<double>(low))),
                            arg("high", number_text(static_cast<double>(high))))};
  return static_cast<float>(v);
}

float number_of(const json& object, const char* name, float low, float high) {
  if (!object.contains(name)) throw missing(name);
  return number(object[name], name, low, high);
}

glm::vec3 three_of(const json& object, const char* name, float low, float high) {
  if (!object.contains(name)) throw missing(name);
  const json& list = object[name];
  if (!list.is_array() || list.size() != 3)
    throw InvalidValue{fill(tr("{name} is not a list of three numbers"), arg("name", name))};
  return {number(list[0], name, low, high), number(list[1], name, low, high), number(list[2], name, low, high)};
}

constexpr float kMaxLight = 1e4f;  // far below the limits of sums of lamps and half floats

Lamp lamp_of(const json& object) {
  constexpr float kSharpest = 60;  // project() has enough samples for it
  Lamp lamp;
  if (!object.is_object()) throw InvalidValue{tr("is not an object")};
  const glm::vec3 towards = three_of(object, "towards", -kMaxLight, kMaxLight);
  const float length = glm::length(towards);
  if (!(length > 1e-6f)) throw InvalidValue{tr("towards is not a direction")};
  lamp.towards = towards / length;
  lamp.sharpness = number_of(object, "sharpness", 0, kSharpest);
  lamp.color = three_of(object, "color", 0, kMaxLight) * number_of(object, "strength", 0, kMaxLight);
  return lamp;
}

/// lines.now is the line that is being read.
std::vector<Lamp> lamps_of(const json& rig, Lines& lines) {
  constexpr size_t kMaxLamps = 64;
  if (!rig.contains("lamps")) throw missing("lamps");
  const json& list = rig["lamps"];
  lines.now = lines.keys["lamps"];
  if (!list.is_array() || list.size() > kMaxLamps)
    throw InvalidValue{fill(tr("lamps is not a list of at most {most} lamps"), arg("most", kMaxLamps))};
  std::vector<Lamp> lamps;
  for (const json& object : list) {
    if (object.is_object() && lamps.size() < lines.lamps.size()) lines.now = lines.lamps[lamps.size()];
    try {
      lamps.push_back(lamp_of(object));
    } catch (const InvalidValue& problem) {
      throw InvalidValue{
          fill(tr("lamp {number}: {problem}"), arg("number", lamps.size() + 1), arg("problem", problem.what))};
    }
  }
  return lamps;
}

LightRig rig_of(const json& object, Lines& lines) {
  lines.now = 1;
  if (!object.is_object()) throw InvalidValue{tr("is not an object with key and lamps")};
  LightRig rig;
  const std::vector<Lamp> lamps = lamps_of(object, lines);
  lines.now = object.contains("key") ? lines.keys["key"] : 1;
  rig.key = three_of(object, "key", 0, kMaxLight);
  if (object.contains("key_radius")) {
    lines.now = lines.keys["key_radius"];
    rig.key_radius = number_of(object, "key_radius", 0, 0.5f);
  }
  rig.sky = project(lamps);
  return rig;
}

}  // namespace

base::Result<LightRig> light_rig_from(std::string_view text) {
  Lines lines;
  try {
    const json object = parse(text, lines);
    return rig_of(object, lines);
  } catch (const InvalidValue& problem) {
    return base::failure(base::ErrorKind::kInput, problem.what, {}, lines.now);
  } catch (const json::exception&) {
    return base::failure(base::ErrorKind::kInput, tr("is invalid JSON from this point"), {}, lines.now);
  }
}

glm::vec3 sky_radiance(const Harmonics& sky, glm::vec3 towards) {
  const std::array<float, 9> basis = harmonics(towards);
  glm::vec3 sum{0};
  for (size_t k = 0; k < basis.size(); ++k) sum += sky[k] * basis[k];
  return glm::max(sum, glm::vec3(0));
}

}  // namespace weftlight::scene
