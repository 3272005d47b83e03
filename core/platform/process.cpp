#include "platform/process.h"

#include <utility>

namespace weftlight::platform {

Process::Process(Process&& other) noexcept { *this = std::move(other); }

Process& Process::operator=(Process&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(reading_, other.reading_);
  std::swap(output_, other.output_);
  std::swap(succeeded_, other.succeeded_);
  return *this;
}

}  // namespace weftlight::platform
