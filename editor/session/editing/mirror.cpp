#include "session/editing/mirror.h"

#include "session/editing/selection_state.h"

namespace weftlight::session {

Mirror mirror_of(const DrawingState& v, const Selection& s, const Draft& d) {
  const GridId grid = grid_id_of(s.grid);
  Mirror m;
  if (v.mirror_ends) m.ends = !s.empty() && has_ends(grid) ? s.a0 + s.a1 - 1 : d.ends() - 1;
  if (v.mirror_picks) m.picks = !s.empty() && has_picks(grid) ? s.b0 + s.b1 - 1 : d.picks() - 1;
  return m;
}

std::vector<Cell> images_of(const Mirror& m, GridId grid, Cell at) {
  std::vector<Cell> all{at};
  if (m.ends && has_ends(grid)) all.push_back({*m.ends - at.a, at.b});
  if (m.picks && has_picks(grid))
    for (size_t i = 0, n = all.size(); i < n; ++i) all.push_back({all[i].a, *m.picks - all[i].b});
  return all;
}

}  // namespace weftlight::session
