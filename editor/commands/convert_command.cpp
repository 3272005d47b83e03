// `convert`: a copy of the draft, the same bytes unless another drive or the plain form is asked for.

#include <cstdio>

#include "commands/commands.h"
#include "draft/edits.h"

namespace weftlight::commands {
namespace {

std::string converted(const WifFile& file, const ConvertOptions& options) {
  const bool liftplan = options.drive == ConvertDrive::kLiftplan, treadling = options.drive == ConvertDrive::kTreadling;
  if (options.plain) {
    return write_plain_wif(file.design, liftplan    ? PlainDrive::kLiftplan
                                        : treadling ? PlainDrive::kTreadling
                                                    : PlainDrive::kAsIs);
  }
  if (liftplan) return write_wif(file, to_liftplan(file.design));
  if (treadling) return write_wif(file, to_treadling(file.design));
  return file.bytes;
}

}  // namespace

int convert_command(const ConvertOptions& options) {
  const OpenedDesign opened = open_design(options.in);
  if (!opened.ok) return kBadInput;
  if (options.drive == ConvertDrive::kTreadling && to_treadling(opened.design).draft.drive != Drive::kTreadling) {
    std::fprintf(stderr, "%s: the draft needs more than %d treadles; keep its liftplan\n", options.in.c_str(),
                 kMaxShafts);
    return kBadInput;
  }
  const std::string error = write_file_atomically(options.out, converted(opened.file, options));
  return error.empty() ? kDone : not_written(error);
}

}  // namespace weftlight::commands
