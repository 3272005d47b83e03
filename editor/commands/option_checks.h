#pragma once
// Checks of what is given to an option, and how its text becomes numbers. Messages are in the user's language.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/text.h"
#include "draft/drawdown.h"

namespace weftlight::commands {

/// The text in quotation marks, cut to fit on a line.
std::string quoted(const std::string& text);

/// Two finite numbers with `between` between them.
bool parse_pair(const std::string& text, char between, float& a, float& b);
/// Limits of a number; by themselves none.
struct Limits {
  float low = -std::numeric_limits<float>::max(), high = std::numeric_limits<float>::max();
};
CLI::Validator pair_of(char between, const std::string& form, Limits first = {}, Limits second = {});

CLI::Validator whole_number(int64_t low, int64_t high);
CLI::Validator number_in(double low, double high);
CLI::Validator above_zero();
CLI::Validator one_of(std::vector<std::string> words);
CLI::Validator one_of_numbers(std::vector<double> numbers);
/// Not empty. `form` stands in the help.
CLI::Validator some_path(const char* form = base::mark("FILE"));

/// Angles in degrees from the normal, below 90 on either side: "0,30,60" or FROM:TO:STEP ("-80:80:5").
base::Result<std::vector<double>> parse_angles(const std::string& text);
/// Reads the text into `out` when it is checked.
CLI::Validator angles_into(std::vector<double>& out);

/// "auto", "auto+0.5" or stops alone, from -20 to 20 EV.
bool parse_exposure(const std::string& text, bool& automatic, float& stops);
CLI::Validator exposure_form();

CLI::Validator environment_file();

/// Adds --quiet and --progress.
void add_progress(CLI::App& verb, bool& quiet, bool& json);
/// Adds --face, front by default.
void add_face(CLI::App& verb, draft::Face& face);

}  // namespace weftlight::commands
