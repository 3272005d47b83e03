#include "session/loom/speaker.h"

#include <chrono>
#include <thread>

#include "platform/catalogue.h"
#include "platform/process.h"
#include "platform/speech.h"

namespace weftlight::session {

Speaker::Speaker() : program_(platform::speaking_program()) {}

void Speaker::say(const std::string& text) {
  if (program_.empty()) return;
  base::Task task;
  task.kind = "say";
  task.work = [words = platform::speaking_words(program_, text, platform::catalogue_language())](
                  const base::RunningTask& running) {
    constexpr std::chrono::milliseconds kLook{20};
    platform::Process speaking(words);
    while (speaking.running() && !running.stopped()) {
      std::this_thread::sleep_for(kLook);
      speaking.look();
    }
  };
  runner_.start(std::move(task));
}

}  // namespace weftlight::session
