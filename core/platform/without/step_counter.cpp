#include "platform/step_counter.h"

namespace weftlight::platform {

std::unique_ptr<StepCounter> StepCounter::start(const Work& /*work*/) { return nullptr; }
StepCounter::~StepCounter() = default;
std::optional<int64_t> StepCounter::count(std::string_view /*request*/) { return std::nullopt; }

}  // namespace weftlight::platform
