#pragma once
// Options that name files, and what the verb does with each. No verb replaces a file that it reads.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace weftlight::commands {

/// A file that the verb reads; also behind an "=", as in --weave 2=rosepath.wif.
CLI::Validator input_file();

/// Extensions that a name may have, in any case. Where there is one format only, a name without any will do, too, such
/// as that of a pipe.
struct Extensions {
  std::vector<std::string> allowed;  // ".png"; empty: all
  bool needed = false;
};
/// A file that the verb writes.
CLI::Validator output_file(Extensions extensions = {});
/// The same where the output is the verb's argument, changed: it may take the place of one with the same extension.
CLI::Validator changed_file(Extensions extensions);

/// A draft, which verbs write as WIF alone.
Extensions draft_extensions();

/// What is wrong with writing this file, if these are read; empty if nothing is.
std::string replaces_input(const std::string& written, const std::vector<std::string>& read);
/// Throws CLI's error if the parsed verb would replace one of its inputs, or one of its outputs another.
void check_files(CLI::App& verb);

}  // namespace weftlight::commands
