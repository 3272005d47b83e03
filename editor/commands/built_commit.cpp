#include "commands/built_commit.h"

#include "base/version.h"
#include "commit.h"  // written at every build by third_party/write_commit.cmake

namespace weftlight::commands {

std::string version_and_commit() {
  const std::string commit = WEFTLIGHT_COMMIT;
  return commit.empty() ? base::version() : base::version() + " (" + commit + ")";
}

}  // namespace weftlight::commands
