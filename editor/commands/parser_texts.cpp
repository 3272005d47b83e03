#include "commands/parser_texts.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "commands/closest_word.h"
#include "commands/option_checks.h"

namespace weftlight::commands {
namespace {

using base::arg;
using base::fill;
using base::tr;

constexpr size_t kColumn = 30, kWidth = 100;  // characters: where descriptions begin, and of a line

/// Continuation bytes of UTF-8 take no room.
size_t letters(std::string_view text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The text in the column of descriptions; its first line begins there, too.
std::string wrapped(const std::string& text) {
  std::string out;
  size_t used = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; used += letters(word)) {
    if (used > 0 && used + 1 + letters(word) > kWidth - kColumn) out.append("\n").append(kColumn, ' '), used = 0;
    if (used > 0) out += ' ', ++used;
    out += word;
  }
  return out;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// As it is typed: "FILE", "-o".
std::string short_name(const CLI::Option& option) {
  if (option.get_positional()) return upper(option.get_name(true));
  const std::vector<std::string>& one_letter = option.get_snames();
  return one_letter.empty() ? option.get_name() : "-" + one_letter.front();
}

/// "WxH", "1..64"; empty for an option that takes no value. A check describes the value better than its type.
std::string value_form(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string type = option.get_type_name();
  // CLI11 writes TYPE:CHECK; a form of ours may have a colon, too: "A:B".
  constexpr std::string_view kTypes[] = {"TEXT", "INT", "UINT", "FLOAT"};
  const size_t checks = type.find(':');
  const bool typed = std::ranges::find(kTypes, std::string_view(type).substr(0, checks)) != std::end(kTypes);
  return typed && checks != std::string::npos ? type.substr(checks + 1) : type;
}

std::string typed_form(const CLI::Option& option) {
  std::string form;
  for (const std::string& letter : option.get_snames()) form += (form.empty() ? "-" : ", -") + letter;
  for (const std::string& name : option.get_lnames()) form += (form.empty() ? "--" : ", --") + name;
  if (const std::string value = value_form(option); !value.empty()) form += " " + value;
  if (option.get_items_expected_max() > 1) form += option.get_delimiter() == '\0' ? " ..." : "[,...]";
  return form;
}

/// The description, and the options that exclude this one.
std::string whole_description(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const CLI::Option* other : option.get_excludes()) names.push_back(other->get_name());
  if (names.empty()) return option.get_description();
  std::sort(names.begin(), names.end());
  return fill(tr("{description}; not with {options}"), arg("description", option.get_description()),
              arg("options", CLI::detail::join(names, ", ")));
}

/// The shown options.
std::vector<const CLI::Option*> options_of(const CLI::App& parser) {
  return parser.get_options([](const CLI::Option* o) { return o->get_positional() || !o->get_group().empty(); });
}

/// The words that belong to no option: the first that looks like one, else the first of all; empty if there are none.
std::string unknown_word(const CLI::App& parser) {
  std::vector<std::string> words = parser.remaining();
  const auto end = std::ranges::find(words, "--");  // of the options
  const auto option =
      std::find_if(words.begin(), end, [](const std::string& w) { return w.size() > 1 && w[0] == '-'; });
  if (option != end) return option->substr(0, option->find('='));
  if (end != words.end()) words.erase(end);
  return words.empty() ? "" : words.front();
}

std::string unknown_text(const CLI::App& parser, const std::string& word) {
  if (word[0] != '-') return fill(tr("unexpected argument {word}"), arg("word", quoted(word)));
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(parser))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::string closest = closest_word(word, names);
  return closest.empty() ? fill(tr("there is no option {option}"), arg("option", quoted(word)))
                         : fill(tr("there is no option {option}; did you mean {closest}?"), arg("option", quoted(word)),
                                arg("closest", closest));
}

std::string missing_text(const CLI::App& parser) {
  for (const CLI::Option* option : options_of(parser))
    if (option->get_required() && option->count() == 0)
      return fill(tr("{option} is required ({what})"), arg("option", short_name(*option)),
                  arg("what", option->get_description()));
  return {};
}

std::string excluded_text(const CLI::App& parser) {
  for (const CLI::Option* option : options_of(parser))
    for (const CLI::Option* other : option->get_excludes())
      if (option->count() > 0 && other->count() > 0)
        return fill(tr("{option} and {other} cannot be given together; leave one out"),
                    arg("option", option->get_name()), arg("other", other->get_name()));
  return {};
}

/// The option that CLI11's message is about, which begins with its name.
const CLI::Option* option_in(const CLI::App& parser, std::string_view said) {
  for (const CLI::Option* option : parser.get_options()) {
    const std::string name = option->get_name();
    if (said.starts_with(name) && said.substr(name.size()).starts_with(":")) return option;
  }
  return nullptr;
}

std::string count_text(const CLI::App& parser, std::string_view said) {
  const CLI::Option* option = option_in(parser, said);
  if (option == nullptr) return {};
  if (option->count() > 1) return fill(tr("{option} may be given only once"), arg("option", short_name(*option)));
  return fill(tr("{option} needs a value: {form}"), arg("option", short_name(*option)),
              arg("form", value_form(*option)));
}

/// The words of option_checks.h, behind the option's name. That of an argument says less than the value, which most
/// words name.
std::string validation_text(const CLI::App& parser, const std::string& said) {
  const CLI::Option* option = option_in(parser, said);
  if (option == nullptr || !option->get_positional()) return said;
  const std::string words = said.substr(option->get_name().size() + 2);  // behind ": "
  const bool names_value = std::ranges::any_of(option->results(), [&words](const std::string& value) {
    return !value.empty() && words.find(quoted(value)) != std::string::npos;
  });
  return names_value ? words : short_name(*option) + ": " + words;
}

/// A value that an option's variable cannot hold, "--json=maybe"; its checks find all others.
std::string conversion_text(const CLI::App& parser, const std::string& said) {
  for (const CLI::Option* option : parser.get_options()) {
    if (option->count() == 0 || said.find(": " + option->get_name() + " = ") == std::string::npos) continue;
    if (option->get_items_expected_max() == 0)
      return fill(tr("{option} takes no value"), arg("option", short_name(*option)));
    return option->get_name() + ": " +
           fill(tr("{text} is not of the form {form}"), arg("text", quoted(option->results().back())),
                arg("form", value_form(*option)));
  }
  return {};
}

}  // namespace

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
  while (help.ends_with("\n\n\n")) help.pop_back();  // CLI11 leaves an empty line for hidden options
  return help;
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  std::string head = "  " + (is_positional ? short_name(*option) : typed_form(*option));
  if (is_positional && option->get_items_expected_max() > 1) head += "...";
  if (!is_positional && option->get_required()) head.append(" ").append(tr("(required)"));
  const size_t used = letters(head);
  head += used < kColumn ? std::string(kColumn - used, ' ') : "\n" + std::string(kColumn, ' ');
  return head + wrapped(whole_description(*option)) + "\n";
}

std::string HelpFormat::make_option_usage(const CLI::Option* option) const {
  return upper(CLI::Formatter::make_option_usage(option));
}

std::string parse_problem(const CLI::App& parser, const CLI::Error& error) {
  std::string said = error.what();
  const bool required = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  std::string text;
  // A mistyped option is the likelier reason for one that is missing.
  if (const std::string word = unknown_word(parser); !word.empty() && (!required || word[0] == '-'))
    text = unknown_text(parser, word);
  else if (required) text = missing_text(parser);
  else if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) text = excluded_text(parser);
  else if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) text = count_text(parser, said);
  else if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) text = conversion_text(parser, said);
  else if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) text = validation_text(parser, said);
  return text.empty() ? tr("invalid arguments") : text;
}

}  // namespace weftlight::commands
