// A page starts no other programs.

#include "platform/process.h"

namespace weftlight::platform {

Process::Process(const std::vector<std::string>& /*words*/) {}
Process::~Process() = default;
void Process::look() {}
bool start_program(const std::vector<std::string>& /*words*/) { return false; }
bool is_program(const std::string& /*name*/, const std::string& /*folders*/) { return false; }

}  // namespace weftlight::platform
