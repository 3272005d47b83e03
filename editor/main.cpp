#include "app/app.h"
#include "commands/commands.h"

int main(int argc, char** argv) {
  const weftlight::commands::CommandLine line = weftlight::commands::run_command_line(argc, argv);
  return line.open_editor ? weftlight::app::run_editor(line.editor) : line.exit_code;
}
