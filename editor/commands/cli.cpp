// The command line: reads the arguments, runs the verb that they name, or leaves the editor to the caller.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <utility>

#include "base/caught.h"
#include "base/languages.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "commands/built_commit.h"
#include "commands/closest_word.h"
#include "commands/commands.h"
#include "commands/file_options.h"
#include "commands/option_checks.h"
#include "commands/parser_texts.h"
#include "commands/verbs.h"
#include "platform/error_line.h"

namespace weftlight::commands {

using base::arg, base::cause_of, base::fill, base::has_language, base::languages_dir, base::tr;

namespace {

constexpr std::string_view kLanguageOption = "--language";

/// "de (Deutsch)"; the code alone if the name is not known.
std::string listed(const base::Language& language) {
  return language.name == language.code ? language.code : language.code + " (" + language.name + ")";
}

CLI::Validator installed_language() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::string folder = languages_dir();
        if (has_language(folder, text)) return std::string{};
        std::vector<std::string> all;
        for (const base::Language& each : base::installed_languages(folder)) all.push_back(listed(each));
        return fill(tr("there is no language {text}; the languages are {languages}"), arg("text", quoted(text)),
                    arg("languages", CLI::detail::join(all, ", ")));
      },
      "LANG");
}

/// Arguments that --language takes from argv[i] on: 0 if it is not that option, 1 for --language=LANG, else 2.
int language_arguments(int argc, char** argv, int i) {
  const std::string_view word = argv[i];
  if (word == kLanguageOption) return std::min(2, argc - i);
  return word.starts_with(kLanguageOption) && word[kLanguageOption.size()] == '=' ? 1 : 0;
}

/// The language is chosen before the arguments are parsed, because the parser's own texts are translated: here the
/// option is only checked.
void add_language(CLI::App& app) {
  app.add_option_function<std::string>(
         std::string(kLanguageOption), [](const std::string&) {},
         tr("Language of all texts, such as de or pt_BR; default: that of the system"))
      ->check(installed_language());
}

/// Refuses a first word that is neither a verb nor looks like a file: the editor would open an empty window.
bool refuse_mistyped_verb(CLI::App& app, const std::string& word) {
  const std::filesystem::path file(word);
  std::error_code ignored;
  if (word.empty() || word[0] == '-' || file.has_extension() || file.has_parent_path()) return false;
  if (std::filesystem::exists(file, ignored)) return false;
  const std::vector<CLI::App*> verbs = app.get_subcommands([](const CLI::App*) { return true; });
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  if (std::ranges::find(names, word) != names.end()) return false;
  const std::string all = CLI::detail::join(names, ", "), closest = closest_word(word, names);
  refuse(closest.empty() ? fill(tr("{word} is neither a command nor a file; the commands are {commands}"),
                                arg("word", quoted(word)), arg("commands", all))
                         : fill(tr("{word} is neither a command nor a file; did you mean '{command}'?"),
                                arg("word", quoted(word)), arg("command", closest)));
  return true;
}

/// The first argument that is not --language.
std::string first_word(int argc, char** argv) {
  int i = 1;
  while (i < argc) {
    const int used = language_arguments(argc, argv, i);
    if (used == 0) break;
    i += used;
  }
  return i < argc ? argv[i] : "";
}

/// A full device reports its error only when the stream is flushed.
int with_output_flushed(int code) {
  std::cout.flush();
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  const int error = errno;
  if (flushed && !std::ferror(stdout) && std::cout) return code;
  print_problem(error == 0 ? std::string(tr("the standard output cannot be written"))
                           : fill(tr("the standard output cannot be written: {cause}"), arg("cause", cause_of(error))));
  std::clearerr(stdout);
  std::cout.clear();
  return code == kDone ? kNotWritten : code;
}

std::string failure_message(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> verbs = app->get_subcommands();
  const std::string program = verbs.empty() ? "weftlight" : "weftlight " + verbs[0]->get_name();
  return fill(tr("{program}: {problem}\nSee {program} --help.\n"), arg("program", program),
              arg("problem", parse_problem(verbs.empty() ? *app : *verbs[0], error)));
}

void translate_help(CLI::App& app) {
  const auto form = std::make_shared<HelpFormat>();
  form->label("Usage", tr("Usage"));
  form->label("Positionals", tr("Arguments"));
  form->label("OPTIONS", tr("OPTIONS"));
  form->label("SUBCOMMAND", tr("COMMAND"));
  app.formatter(form);
  app.option_defaults()->group(tr("Options"));
  app.set_help_flag("-h,--help", tr("This help"));
}

void add_editor_options(CLI::App& app, EditorOptions& options) {
  app.add_option("file", options.files, tr("Drafts to open in the editor, each in a tab"));
  app.add_option("--live-export", options.live_export, tr("Editor: .wif file that every edit is written to"))
      ->type_name(tr("FILE"));
  app.add_option("--ui-map", options.ui_map, tr("Editor: JSON file for the positions of the controls"))
      ->type_name(tr("FILE"));
}

RunVerb add_verb(CLI::App& app, const Verb& verb) {
  CLI::App& parser = *app.add_subcommand(verb.name, tr(verb.description))->group(tr("Commands"));
  parser.set_help_flag("-h,--help", tr("This help"));
  RunVerb run = verb.add_options(parser);
  add_language(parser);
  parser.final_callback([&parser] { check_files(parser); });
  return run;
}

/// What a verb throws, memory above all, becomes a message. Output files are whole or absent (base/whole_files.h).
int run_verb(std::string_view name, const RunVerb& run) {
  try {
    return run();
  } catch (...) {
    platform::write_error_line("weftlight " + std::string(name) + ": " + base::words_of_thrown());
    const bool reads_only = name == "info" || name == "analyse" || name == "diff";
    return reads_only ? kBadInput : kNotWritten;
  }
}

}  // namespace

std::string requested_language(int argc, char** argv) {
  std::string language;
  for (int i = 1; i < argc; ++i) {
    const int used = language_arguments(argc, argv, i);
    if (used == 0) continue;
    const std::string_view word = argv[i + used - 1];
    language = used == 2 ? word : word.substr(std::min(word.size(), kLanguageOption.size() + 1));
    i += used - 1;
  }
  return has_language(languages_dir(), language) ? language : "";
}

CommandLine run_command_line(int argc, char** argv) {
  CommandLine result;
  CLI::App app{tr("Weftlight: paint a draft and see its cloth at once, lit and draped")};
  app.name("weftlight");
  app.allow_windows_style_options(false);  // there, too, /drafts/twill.wif is a file and no option
  translate_help(app);
  app.set_version_flag("--version", "weftlight " + version_and_commit(), tr("The version of the program"));
  app.require_subcommand(0, 1);
  app.failure_message(failure_message);
  add_editor_options(app, result.editor);
  add_language(app);
  std::vector<std::pair<const char*, RunVerb>> runs;
  for (const std::span<const Verb> verbs : {draft_verbs(), cloth_verbs(), shell_verbs()})
    for (const Verb& verb : verbs) runs.emplace_back(verb.name, add_verb(app, verb));

  if (refuse_mistyped_verb(app, first_word(argc, argv))) {
    result.exit_code = kUsage;
    return result;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    result.exit_code = with_output_flushed(app.exit(error) == 0 ? kDone : kUsage);
    return result;
  }
  result.open_editor = true;
  for (const auto& [name, run] : runs) {
    if (!app.got_subcommand(name)) continue;
    result.open_editor = false;
    result.exit_code = with_output_flushed(run_verb(name, run));
  }
  return result;
}

}  // namespace weftlight::commands
