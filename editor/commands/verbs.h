#pragma once
// The table of the headless verbs. Each entry adds its options to the parser and returns what runs the parsed verb.

#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace weftlight::commands {

/// Returns an exit code of the contract.
using RunVerb = std::function<int()>;

struct Verb {
  const char *name, *description;  // tr(description) where it is shown
  RunVerb (*add_options)(CLI::App& verb);
};

/// Verbs for drafts: info, find, analyse, print, weave, diff, join, yarns, drawdown, convert.
std::span<const Verb> draft_verbs();
/// Verbs for the cloth: render, reference, export, chart, response, drape, curves.
std::span<const Verb> cloth_verbs();
/// Verbs for the shell: completion, manual.
std::span<const Verb> shell_verbs();

}  // namespace weftlight::commands
