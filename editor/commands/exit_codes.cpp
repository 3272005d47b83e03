#include "commands/exit_codes.h"

#include "base/text.h"
#include "platform/error_line.h"

namespace weftlight::commands {

using base::ErrorKind, base::arg, base::fill, base::message, base::tr;
using platform::write_error_line;

void print_problem(const std::string& problem) { write_error_line("weftlight: " + problem); }

Exit exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return kUsage;
    case ErrorKind::kInput:
    case ErrorKind::kMemory:  // for what was read
      return kBadInput;
    case ErrorKind::kGraphics:
      return kNoGraphics;
    case ErrorKind::kOutput:
    case ErrorKind::kCancelled:
      break;
  }
  return kNotWritten;
}

int fail(const base::Error& error) {
  const std::string what = message(error);
  if (error.kind == ErrorKind::kOutput)
    write_error_line(fill(tr("{problem}; choose another location"), arg("problem", what)));
  else if (error.file.empty()) print_problem(what);
  else write_error_line(what);
  return exit_code(error.kind);
}

int refuse(const std::string& problem) { return fail({ErrorKind::kUsage, problem}); }

int finish(const base::Result<void>& result) { return result ? kDone : fail(result.error()); }

}  // namespace weftlight::commands
