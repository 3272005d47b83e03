// Rays among the threads of threads.glsl, which includes this file.

struct ThreadHit {
  int system;       // -1: a gap
  int layer;
  Strand strand;
  vec3 at;
};

FORMULA ThreadHit hit_of(Crossing c, vec3 p, vec2 d) {
  ThreadHit hit;
  bool warp = d.x <= d.y;
  hit.system = warp ? 0 : 1;
  hit.layer = 0;
  hit.strand = c.weft;
  if (warp) hit.strand = c.warp;
  hit.at = p;
  return hit;
}

// Vertical view, or nearly: the higher of both strands over the position.
FORMULA ThreadHit thread_below(ThreadGrid g, vec2 at, vec2 lean) {
  Crossing c;
  vec3 p = vec3(at, 0.0f);
  float warp = 0.0f;
  float weft = 0.0f;
  for (int k = 0; k < 2; ++k) {
    c = crossing_near(g, vec2(p.x, p.y));
    // Approximate at first: a ray this steep hardly moves.
    warp = strand_top(c.warp, p.x, p.y, 2 * k);
    weft = strand_top(c.weft, p.y, p.x, 2 * k);
    float z = max(max(warp, weft), g.bottom);
    p = vec3(at + lean * z, z);
  }
  ThreadHit hit = hit_of(c, p, vec2(-warp, -weft));
  if (max(warp, weft) < -1.0e5f) hit.system = -1;
  return hit;
}

// A ray parametrised by height: at height z it is over at + lean * z. Returns where it leaves a crossing's cell on its
// way down (way -1) or up (way 1).
FORMULA float cell_exit(Crossing c, vec2 at, vec2 lean, float way) {
  vec2 run = lean * way;
  float x = abs(lean.x) < 1.0e-6f ? 1.0e9f : ((run.x < 0.0f ? c.low.x : c.high.x) - at.x) / lean.x * way;
  float y = abs(lean.y) < 1.0e-6f ? 1.0e9f : ((run.y < 0.0f ? c.low.y : c.high.y) - at.y) / lean.y * way;
  return min(x, y) * way;
}

// Smallest step of a ray in a cell: a cord's crossing is many times as high as a fine thread over it is thick.
FORMULA float step_in_cell(ThreadGrid g, Crossing c, float rise) {
  float most = float(kMaxStepsInCell);
  if (g.layers > 1) most *= max(0.5f * (g.top - g.bottom) / g.reach, 1.0f);
  float step = rise / clamp(ceil(rise * kStepsInTop / g.reach), float(kMinStepsInCell), most);
  return min(step, min(c.warp.half_height, c.weft.half_height));
}

FORMULA float distance_to(ThreadHit h, vec3 p) {
  return strand_distance(h.strand, h.system == 0 ? p.x : p.y, h.system == 0 ? p.y : p.x, p.z);
}

// False position between a height outside the thread and one inside.
FORMULA vec3 surface_between(ThreadHit h, vec2 at, vec2 lean, float high, float low, float above, float under) {
  vec3 p = vec3(at + lean * low, low);
  for (int k = 0; k < 5; ++k) {
    float z = low + (high - low) * clamp(-under / max(above - under, 1.0e-6f), 0.02f, 0.98f);
    p = vec3(at + lean * z, z);
    float now = distance_to(h, p);
    // The end that stays is halved from then on (Illinois), or it would slow down convergence.
    if (now < 0.0f) {
      low = z;
      under = now;
      above *= 0.5f;
    } else {
      high = z;
      above = now;
      under *= 0.5f;
    }
  }
  return p;
}

// Walks from cell to cell, since fetching a crossing costs more than the steps in it, and refines the hit last, so
// that neighbouring rays do so together.
FORMULA ThreadHit first_in_layer(ThreadGrid g, vec2 at, vec2 lean, int most) {
  float slant = length(lean);
  if (most == 0 || (g.top - g.bottom) * slant < 0.06f * g.spacing) return thread_below(g, at, lean);
  float nudge = 1.0e-4f * g.spacing / slant;
  float safe = kSafe * inversesqrt(1.0f + slant * slant);   // heights that a distance holds
  float z = g.top;
  float next;
  float above = g.reach;
  vec2 d = vec2(g.reach);
  Crossing c;
  int i = 0;
  do {
    c = crossing_near(g, at + lean * (z - nudge));
    float end = max(min(cell_exit(c, at, lean, -1.0f), z - nudge), g.bottom);
    float least = step_in_cell(g, c, z - end);
    float down = least;
    do {
      next = max(z - down, end);
      d = near_distances(c, vec3(at + lean * next, next));
      if (min(d.x, d.y) >= 0.0f) {
        above = min(d.x, d.y);
        z = next;
      }
      down = max(least, above * safe);
    } while (next > end && min(d.x, d.y) >= 0.0f);
    ++i;
  } while (i < most && z > g.bottom && min(d.x, d.y) >= 0.0f);
  ThreadHit hit = hit_of(c, vec3(at + lean * next, next), d);
  if (min(d.x, d.y) >= 0.0f) hit.system = -1;
  else hit.at = surface_between(hit, at, lean, z, next, above, min(d.x, d.y));
  return hit;
}

// First thread on the ray that crosses the middle plane at `at`, from direction v. most: largest number of cells; 0
// asks for the thread straight below.
FORMULA ThreadHit first_thread(ThreadGrid g, vec2 at, vec3 v, int most) {
  vec2 lean = vec2(v.x, v.y) / max(v.z, 0.04f);   // for a height of 1
  ThreadHit hit = first_in_layer(g, at, lean, most);
#if !defined(ONE_LAYER)
  for (int i = 1; i < g.layers; ++i) {
    ThreadHit found = first_in_layer(thread_layer(i, g.side), at, lean, most);
    if (found.system < 0 || (hit.system >= 0 && found.at.z <= hit.at.z)) continue;
    hit = found;
    hit.layer = i;
  }
#endif
  return hit;
}

FORMULA bool layer_blocks(ThreadGrid g, vec3 from, vec3 l, int most, int system, int thread) {
  float way = l.z < 0.0f ? -1.0f : 1.0f;
  vec2 lean = vec2(l.x, l.y) / (way * max(abs(l.z), 0.02f));
  vec2 at = vec2(from.x, from.y) - lean * from.z;
  float nudge = 1.0e-4f * g.spacing / max(length(lean), 1.0e-3f);
  float safe = kSafe * inversesqrt(1.0f + dot(lean, lean));
  float last = way > 0.0f ? g.top : -g.bottom;
  float z = way * from.z;   // grows towards the light
  // A layer further along the ray.
  if (g.layers > 1) z = max(z, way > 0.0f ? g.bottom : -g.top);
  bool blocked = false;
  int i = 0;
  do {
    Crossing c = crossing_near(g, at + lean * (way * (z + nudge)));
    float end = min(max(way * cell_exit(c, at, lean, way), z + nudge), last);
    float least = step_in_cell(g, c, end - z);
    float height = z + 0.5f * least;
    do {
      vec2 d = near_distances(c, vec3(at + lean * (way * height), way * height));
      if (system == 0 && c.warp.thread == thread) d.x = 1.0e9f;
      if (system == 1 && c.weft.thread == thread) d.y = 1.0e9f;
      blocked = blocked || min(d.x, d.y) < 0.0f;
      height += max(least, min(d.x, d.y) * safe);
    } while (height < end && !blocked);
    z = end;
    ++i;
  } while (i < most && z < last && !blocked);
  return blocked;
}

// Whether a thread occludes a distant light, on either side of the cloth; most: largest number of cells. The point's
// own thread does not count, since it bends too little to occlude itself. system -1: all threads count.
FORMULA bool threads_block(ThreadGrid g, vec3 from, vec3 l, int most, int system, int thread) {
  bool blocked = layer_blocks(g, from, l, most, system, thread);
#if !defined(ONE_LAYER)
  for (int i = 1; i < g.layers && !blocked; ++i) {
    blocked = layer_blocks(thread_layer(i, g.side), from, l, most, system, thread);
  }
#endif
  return blocked;
}
