#pragma once
// An environment variable, set while a test runs.

#include <cstdlib>
#include <optional>
#include <string>

#include "platform/environment_variables.h"

namespace weftlight {

class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    platform::set_variable(name, value);
  }
  ~Variable() { platform::set_variable(name_, before_.value_or("")); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace weftlight
