// A page starts no other programs.

#include "platform/process.h"

#include <utility>

namespace weftlight::platform {

Process::Process(const std::vector<std::string>& /*words*/) {}
Process::~Process() = default;
Process::Process(Process&& other) noexcept { *this = std::move(other); }
Process& Process::operator=(Process&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(reading_, other.reading_);
  std::swap(output_, other.output_);
  std::swap(succeeded_, other.succeeded_);
  return *this;
}
void Process::look() {}
bool start_program(const std::vector<std::string>& /*words*/) { return false; }
bool is_program(const std::string& /*name*/, const std::string& /*folders*/) { return false; }

}  // namespace weftlight::platform
