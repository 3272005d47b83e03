#include "platform/speech.h"

#include "platform/environment_variables.h"
#include "platform/process.h"

namespace weftlight::platform {

std::string speaking_program() {
  // eSpeak speaks at once; speech-dispatcher goes through a service; the last one is that of macOS.
  for (const char* name : {"espeak-ng", "espeak", "spd-say", "say"})
    if (is_program(name, variable("PATH"))) return name;
  return {};
}

std::vector<std::string> speaking_words(const std::string& program, const std::string& text,
                                        const std::string& language) {
  const std::string spoken = language.empty() || language == "C" ? "en" : language.substr(0, 2);
  if (program == "spd-say") return {program, "--wait", "--language", spoken, "--", text};
  if (program == "say") return {program, "--", text};
  return {program, "-v", spoken, "--", text};
}

}  // namespace weftlight::platform
