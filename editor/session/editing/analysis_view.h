#pragma once
// What the analysis of a draft is asked: the longest float allowed, and whether longer ones are shown.

#include "analysis/floats.h"

namespace weftlight::session {

struct AnalysisView {
  int float_limit = analysis::kFloatLimit;  // longest float allowed, in threads
  bool show_floats = false;                 // longer floats are tinted in the drawdown
};

}  // namespace weftlight::session
