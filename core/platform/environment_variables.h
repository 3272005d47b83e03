#pragma once
// How this program was started: its environment variables and its console.

#include <string>

namespace weftlight::platform {

/// Empty if the variable is not set.
std::string variable(const char* name);
/// For this program and those that it starts; empty: not set any more. Call it while no other thread runs that reads
/// variables.
void set_variable(const char* name, const std::string& value);

/// Whether a person sees the error output (stderr): it is a terminal, not a file or a pipe.
bool errors_go_to_terminal();

}  // namespace weftlight::platform
