#include "commands/file_options.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/file_names.h"
#include "base/text.h"
#include "commands/option_checks.h"

namespace weftlight::commands {

using base::arg, base::extension_of, base::fill, base::same_file, base::tr;

namespace {

// Names of validators, by which check_files() knows what is done with a file.
constexpr const char *kRead = "read", *kWritten = "written", *kChanged = "changed";

bool has_check(CLI::Option& option, const char* name) {
  try {
    return option.get_validator(name) != nullptr;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

/// ".pdf, .svg or .png".
std::string any_of(const std::vector<std::string>& extensions) {
  if (extensions.size() < 2) return CLI::detail::join(extensions, ", ");
  const std::vector<std::string> first(extensions.begin(), extensions.end() - 1);
  return fill(tr("{first} or {last}"), arg("first", CLI::detail::join(first, ", ")), arg("last", extensions.back()));
}

std::string name_problem(const std::string& name, const Extensions& extensions) {
  if (name.empty()) return tr("the name is empty");
  const std::string extension = extension_of(name);
  const bool any = extensions.allowed.empty() || (extension.empty() && !extensions.needed);
  if (name == "-" && any) return tr("a - is no file; the standard output is /dev/stdout");
  if (any) return {};
  if (std::ranges::count(extensions.allowed, extension) > 0) return {};
  return fill(tr("{file} must end in {extensions}"), arg("file", quoted(name)),
              arg("extensions", any_of(extensions.allowed)));
}

CLI::Validator checked_name(Extensions extensions) {
  return CLI::Validator(
      [extensions = std::move(extensions)](const std::string& name) { return name_problem(name, extensions); },
      tr("FILE"));
}

/// The files that a verb reads.
struct Inputs {
  std::vector<std::string> arguments, options;
};

Inputs inputs_of(const std::vector<CLI::Option*>& options) {
  Inputs inputs;
  for (CLI::Option* option : options) {
    if (!has_check(*option, kRead)) continue;
    for (const std::string& value : option->results()) {
      std::vector<std::string>& files = option->get_positional() ? inputs.arguments : inputs.options;
      files.push_back(value);
      if (const size_t equals = value.find('='); equals != std::string::npos) files.push_back(value.substr(equals + 1));
    }
  }
  return inputs;
}

/// What an output of the verb may not replace.
std::vector<std::string> kept(const Inputs& inputs, const std::string& output, bool changed) {
  std::vector<std::string> files = inputs.options;
  for (const std::string& file : inputs.arguments)
    if (!changed || extension_of(file) != extension_of(output)) files.push_back(file);
  return files;
}

}  // namespace

CLI::Validator input_file() {
  return CLI::Validator(
      [](const std::string& name) -> std::string { return name.empty() ? tr("the name is empty") : ""; }, "", kRead);
}

CLI::Validator output_file(Extensions extensions) { return checked_name(std::move(extensions)).name(kWritten); }

CLI::Validator changed_file(Extensions extensions) { return checked_name(std::move(extensions)).name(kChanged); }

Extensions draft_extensions() { return {{".wif", ".wifw"}}; }

std::string replaces_input(const std::string& written, const std::vector<std::string>& read) {
  const bool replaces = std::ranges::any_of(read, [&written](const std::string& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error) && same_file(file, written);
  });
  if (!replaces) return {};
  return fill(tr("{file} is read by the command; give the output another name"), arg("file", quoted(written)));
}

void check_files(CLI::App& verb) {
  const std::vector<CLI::Option*> options = verb.get_options({});
  const Inputs inputs = inputs_of(options);
  std::vector<std::string> written;
  for (CLI::Option* option : options) {
    const bool changed = has_check(*option, kChanged);
    if (!changed && !has_check(*option, kWritten)) continue;
    for (const std::string& file : option->results()) {
      if (const std::string problem = replaces_input(file, kept(inputs, file, changed)); !problem.empty())
        throw CLI::ValidationError(option->get_name(), problem);
      if (std::ranges::any_of(written, [&file](const std::string& other) { return same_file(file, other); }))
        throw CLI::ValidationError(
            option->get_name(),
            fill(tr("{file} is named as two outputs; give one of them another name"), arg("file", quoted(file))));
      written.push_back(file);
    }
  }
}

}  // namespace weftlight::commands
