#include "platform/shipped_file.h"

#include "platform/file.h"

namespace weftlight::platform {

bool is_shipped(const std::string& path) { return file_facts(path).kind == FileKind::kRegular; }

}  // namespace weftlight::platform
