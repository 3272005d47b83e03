#pragma once
// What the analysis of a draft is asked: the longest float allowed, and the size of the finished cloth.

namespace weftlight::session {

struct AnalysisView {
  int float_limit = 5;                            // longest float allowed, in threads
  bool show_floats = false;                       // longer floats are tinted in the drawdown
  float cloth_length_cm = 0, cloth_width_cm = 0;  // finished cloth for the yarn estimate; 0: size of the draft
};

}  // namespace weftlight::session
