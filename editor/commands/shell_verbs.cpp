// The manual page and the completions of the shells, both made from the options themselves.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "base/text.h"
#include "base/version.h"
#include "commands/commands.h"
#include "commands/option_checks.h"
#include "commands/verbs.h"

namespace weftlight::commands {

using base::mark, base::tr;

namespace {

/// What the shells need to know of an option or an argument.
struct OptionFacts {
  std::string long_name, short_name;  // without dashes; both empty for an argument
  std::string argument;               // name of an argument: "file"
  std::string description, value;     // value: its type in words, "WxH"; empty for a flag
  std::vector<std::string> choices;   // the values, if they are few
  bool required = false;
};

struct VerbFacts {
  std::string name, description;
  std::vector<OptionFacts> options;
};

/// The words of "front|back"; none where a part stands for something: "EV|auto", "FILE.hdr|FILE.exr".
std::vector<std::string> choices_in(const std::string& value) {
  const auto is_word = [](const std::string& part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
  };
  std::vector<std::string> parts = CLI::detail::split(value, '|');
  return parts.size() > 1 && std::all_of(parts.begin(), parts.end(), is_word) ? parts : std::vector<std::string>{};
}

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  if (!option.get_lnames().empty()) facts.long_name = option.get_lnames()[0];
  if (!option.get_snames().empty()) facts.short_name = option.get_snames()[0];
  if (facts.long_name.empty() && facts.short_name.empty()) facts.argument = option.get_name(true);
  facts.description = option.get_description();
  std::string type = option.get_type_name();  // "TEXT:front|back"
  if (const size_t colon = type.find(':'); colon != std::string::npos) type.erase(0, colon + 1);
  if (option.get_type_size() != 0) facts.value = type, facts.choices = choices_in(type);
  facts.required = option.get_required();
  return facts;
}

VerbFacts facts_of(const CLI::App& app) {
  VerbFacts facts{app.get_name(), app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) facts.options.push_back(facts_of(*option));
  return facts;
}

/// The program itself first, then its verbs.
std::vector<VerbFacts> all_facts(const CLI::App& program) {
  std::vector<VerbFacts> all{facts_of(program)};
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; }))
    all.push_back(facts_of(*verb));
  return all;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

/// Between single quotes of a POSIX shell or of fish.
std::string in_quotes(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::vector<std::string> words_of(const OptionFacts& option) {
  std::vector<std::string> words;
  if (!option.long_name.empty()) words.push_back("--" + option.long_name);
  if (!option.short_name.empty()) words.push_back("-" + option.short_name);
  return words;
}

std::string bash_completion(const std::vector<VerbFacts>& all) {
  std::string verbs, values, options;
  for (const VerbFacts& verb : all) {
    const bool program = &verb == &all[0];
    if (!program) verbs += (verbs.empty() ? "" : " ") + verb.name;
    std::string words;
    for (const OptionFacts& option : verb.options) {
      for (const std::string& word : words_of(option)) {
        words += (words.empty() ? "" : " ") + word;
        if (!option.choices.empty())
          values += "    '" + (program ? "" : verb.name) + " " + word + "') words='" +
                    CLI::detail::join(option.choices, " ") + "' ;;\n";
      }
    }
    options += "    '" + (program ? "" : verb.name) + "') words='" + words + "' ;;\n";
  }
  return "# bash completion of weftlight\n"
         "_weftlight() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb= word words=\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \" " +
         verbs +
         " \" in *\" $word \"*) verb=$word; break ;; esac\n"
         "  done\n"
         "  case \"$verb $before\" in\n" +
         values +
         "  esac\n"
         "  if [[ -z $words && $current == -* ]]; then\n"
         "    case \"$verb\" in\n" +
         options +
         "    esac\n"
         "  fi\n"
         "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$current\")); return; fi\n"
         "  mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  if [[ -z $verb && COMP_CWORD -eq 1 ]]; then\n"
         "    COMPREPLY+=($(compgen -W '" +
         verbs +
         "' -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _weftlight weftlight\n";
}

/// Inside '[...]' and ':...' of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_arguments(const VerbFacts& verb) {
  std::string text = "_arguments -s";
  for (const OptionFacts& option : verb.options) {
    const std::string value = option.value.empty()     ? ""
                              : option.choices.empty() ? ":" + zsh_text(option.value) + ":_files"
                                                       : ": :(" + CLI::detail::join(option.choices, " ") + ")";
    for (const std::string& word : words_of(option))
      text += " \\\n        " + in_quotes("*" + word + "[" + zsh_text(option.description) + "]" + value);
  }
  return text + " \\\n        '*:file:_files'";
}

std::string zsh_completion(const std::vector<VerbFacts>& all) {
  std::string verbs, cases;
  for (size_t i = 1; i < all.size(); ++i) {
    verbs += "    " + in_quotes(zsh_text(all[i].name) + ":" + zsh_text(all[i].description)) + "\n";
    cases += "    " + all[i].name + ")\n      " + zsh_arguments(all[i]) + " ;;\n";
  }
  return "#compdef weftlight\n"
         "_weftlight() {\n"
         "  local -a verbs\n"
         "  verbs=(\n" +
         verbs +
         "  )\n"
         "  if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
         "    _describe -t commands command verbs\n"
         "    _files\n"
         "    return\n"
         "  fi\n"
         "  case $words[2] in\n" +
         cases + "    *)\n      " + zsh_arguments(all[0]) +
         " ;;\n"
         "  esac\n"
         "}\n"
         "_weftlight \"$@\"\n";
}

std::string fish_completion(const std::vector<VerbFacts>& all) {
  std::string verbs;
  for (size_t i = 1; i < all.size(); ++i) verbs += (i > 1 ? " " : "") + all[i].name;
  std::string text = "# fish completion of weftlight\n";
  for (const VerbFacts& verb : all) {
    const bool program = &verb == &all[0];
    const std::string when = program ? in_quotes("not __fish_seen_subcommand_from " + verbs)
                                     : in_quotes("__fish_seen_subcommand_from " + verb.name);
    if (!program)
      text += "complete -c weftlight -n " + in_quotes("not __fish_seen_subcommand_from " + verbs) + " -a " + verb.name +
              " -d " + in_quotes(verb.description) + "\n";
    for (const OptionFacts& option : verb.options) {
      if (!option.argument.empty()) continue;
      text += "complete -c weftlight -n " + when;
      if (!option.long_name.empty()) text += " -l " + option.long_name;
      if (!option.short_name.empty()) text += " -s " + option.short_name;
      if (!option.choices.empty()) text += " -x -a " + in_quotes(CLI::detail::join(option.choices, " "));
      else if (!option.value.empty()) text += " -r";
      text += " -d " + in_quotes(option.description) + "\n";
    }
  }
  return text;
}

/// Text for troff: no line begins with a control character, and dashes are dashes that can be copied.
std::string troff(const std::string& text) {
  const std::string plain = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  return plain.starts_with('.') || plain.starts_with('\'') ? "\\&" + plain : plain;
}

std::string man_option(const OptionFacts& option) {
  std::string head;
  for (const std::string& word : words_of(option)) head += (head.empty() ? "\\fB" : ", \\fB") + troff(word) + "\\fR";
  if (!option.argument.empty()) head = "\\fI" + troff(option.argument) + "\\fR";
  else if (!option.value.empty()) head += " \\fI" + troff(option.value) + "\\fR";
  return ".TP\n" + head + "\n" + troff(option.description) + "\n";
}

std::string man_page(const std::vector<VerbFacts>& all) {
  std::string text =
      ".TH WEFTLIGHT 1 \"\" \"weftlight " + base::version() + "\"\n.SH NAME\nweftlight \\- " +
      troff(tr("paint a draft and see the real cloth, lit and draped, at once")) +
      "\n.SH SYNOPSIS\n.B weftlight\n[\\fIoptions\\fR] [\\fIfile\\fR]\n.br\n.B weftlight\n\\fIcommand\\fR "
      "[\\fIoptions\\fR] \\fIfile\\fR ...\n.SH OPTIONS\n";
  for (const OptionFacts& option : all[0].options) text += man_option(option);
  text += ".SH COMMANDS\n";
  for (size_t i = 1; i < all.size(); ++i) {
    text += ".SS weftlight " + troff(all[i].name) + "\n" + troff(all[i].description) + ".\n";
    for (const OptionFacts& option : all[i].options)
      if (option.long_name != "help" && option.long_name != "language") text += man_option(option);
  }
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : {std::pair{kDone, tr("Done.")},
                                      {kUsage, tr("The command line is wrong.")},
                                      {kBadInput, tr("The input cannot be used.")},
                                      {kNoGraphics, tr("OpenGL is not available.")},
                                      {kNotWritten, tr("The output cannot be written.")}})
    text += ".TP\n" + std::to_string(code) + "\n" + troff(meaning) + "\n";
  return text;
}

struct CompletionOptions {
  std::string shell;
};

int print_text(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kDone;
}

RunVerb add_completion(CLI::App& verb) {
  auto options = std::make_shared<CompletionOptions>();
  verb.add_option("shell", options->shell, tr("Shell that completes the commands"))
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
  return [&verb, options] {
    const std::vector<VerbFacts> all = all_facts(*verb.get_parent());
    return print_text(options->shell == "bash"  ? bash_completion(all)
                      : options->shell == "zsh" ? zsh_completion(all)
                                                : fish_completion(all));
  };
}

RunVerb add_manual(CLI::App& verb) {
  return [&verb] { return print_text(man_page(all_facts(*verb.get_parent()))); };
}

constexpr Verb kVerbs[] = {
    {"completion", mark("Print what a shell needs to complete commands and options"), add_completion},
    {"manual", mark("Print the manual page, for man"), add_manual},
};

}  // namespace

std::span<const Verb> shell_verbs() { return kVerbs; }

}  // namespace weftlight::commands
