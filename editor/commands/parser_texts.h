#pragma once
// What the parser of the command line says, in the user's language: its help, and what is wrong with the arguments. The
// words of CLI11 itself are English and cannot be translated.

#include <CLI/CLI.hpp>
#include <string>

namespace weftlight::commands {

/// One option a line, as it is typed: its names, its value ("-o, --output FILE") and its description, wrapped.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_usage(const CLI::Option* option) const override;
};

/// What is wrong with the arguments of the program or the verb `parser`, and what to do.
std::string parse_problem(const CLI::App& parser, const CLI::Error& error);

}  // namespace weftlight::commands
