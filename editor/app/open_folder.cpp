#include "app/open_folder.h"

#include <spawn.h>
#include <sys/wait.h>

#include <system_error>
#include <thread>

#include "base/text.h"

extern char** environ;

namespace weftlight::app {

using base::arg;
using base::fill;
using base::tr;

std::string open_folder(const std::string& folder) {
  std::string words[] = {"xdg-open", folder};
  char* argv[] = {words[0].data(), words[1].data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv, environ) != 0)
    return fill(tr("No program shows folders here (xdg-open is missing). The folder is {folder}"),
                arg("folder", folder));
  // A thread of its own waits for the process, so that none is left defunct.
  try {
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
  } catch (const std::system_error&) {  // without a thread it stays defunct until the program ends
  }
  return {};
}

}  // namespace weftlight::app
