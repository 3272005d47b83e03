// Double cloth and cloths of more layers. The ends of the layers take turns, the uppermost first. A pick of a layer
// lifts all ends of the layers above it and leaves those below it down.

#include <algorithm>

#include "weaves/families.h"

namespace weftlight::weaves {

using design::Design;
using draft::BitMatrix, draft::System;

namespace {

// picks x ends of one layer: 1 where the end is up.
BitMatrix layer_weave(const OverUnder& order) {
  const Recipe twill = twill_recipe(order, Lean::kRight);
  BitMatrix up(twill.shafts, twill.shafts);
  for (int t = 0; t < twill.shafts; ++t)
    for (const int s : twill.tieup[static_cast<size_t>(t)]) up.set(t, s, true);
  return up;
}

// Layers of n shafts each; shaft s of layer l is s * layers + l, and so are the treadles.
struct Layers {
  const BitMatrix& weave;
  int layers = 2;
  bool folded = false;

  int n() const { return weave.cols(); }
  int of(int layer, int thread) const { return thread * layers + layer; }
  // Every second layer is seen from below, so its weave is inverted; where it is the same cloth, folded, it is
  // mirrored, too.
  bool up(int layer, int pick, int s) const {
    const bool below = layer % 2 == 1;
    return weave.get(pick, below && folded ? n() - 1 - s : s) != below;
  }
  std::vector<int> treadle(int layer, int pick) const {
    std::vector<int> shafts;
    for (int s = 0; s < n(); ++s) {
      for (int above = 0; above < layer; ++above) shafts.push_back(of(above, s));
      if (up(layer, pick, s)) shafts.push_back(of(layer, s));
    }
    return shafts;
  }
  Recipe recipe() const {
    Recipe out{layers * n(), {}, {}, {}};
    for (int s = 0; s < layers * n(); ++s) out.threading.push_back(s);
    for (int p = 0; p < n(); ++p)
      for (int layer = 0; layer < layers; ++layer) out.tieup.push_back(treadle(layer, p));
    return out;
  }
};

// Each layer has the sett that it would have alone.
Design with_layer_sett(Design design, const OverUnder& ratio, int layers) {
  const int n = layer_weave(ratio).cols();
  const Design alone = twill(ratio, Lean::kRight, {n, n});
  for (const System system : {System::kWarp, System::kWeft})
    for (float& mm : design.draft.threads(system).spacing_mm)
      mm = alone.draft.threads(system).spacing_mm[0] / static_cast<float>(layers);
  return design;
}

// Threads of the layers in turn light and dark.
Design with_layer_colors(Design design, const std::vector<int>& treadling, int layers) {
  const auto tone = [](int layer) { return layer % 2; };
  for (size_t e = 0; e < design.draft.warp.color.size(); ++e)
    design.draft.warp.color[e] = tone(static_cast<int>(e) % layers);
  for (size_t p = 0; p < design.draft.weft.color.size(); ++p)
    design.draft.weft.color[p] = tone(treadling[p % treadling.size()] % layers);
  return design;
}

// Floats beside a stitch that hide it: of the ends on both sides over (under) the pick, and of the stitched end itself
// over (under) the picks of its layer before and after. Layer 0 is the upper one.
int hidden(const BitMatrix& weave, int pick, int end, bool from_below) {
  const int n = weave.cols();
  const auto at = [&](int p, int e) { return weave.get((p + n) % n, (e + n) % n); };
  if (from_below) return 2 * (at(pick, end) + at(pick, end + 1)) + !at(pick - 1, end) + !at(pick, end);
  return 2 * (at(pick, end - 1) + at(pick, end)) + !at(pick, end) + !at(pick + 1, end);
}

}  // namespace

Design double_cloth(DoubleCloth kind, const OverUnder& order, ClothSize size, int layers) {
  const OverUnder ratio = order.empty() ? OverUnder{1, 1} : order;
  const BitMatrix weave = layer_weave(ratio);
  const int most = std::clamp(layers, 2, 8);
  const Layers cloth{weave, most, kind != DoubleCloth::kLayers};
  Recipe recipe = cloth.recipe();
  // Order of the shuttle: from the top down; a folded cloth is woven down and up again, so that its layers are joined
  // by folds at the selvedges.
  for (int p = 0; p < 2 * cloth.n(); ++p)
    for (int i = 0; i < most; ++i) {
      const bool back = kind == DoubleCloth::kDoubleWidth && p % 2 == 1;
      recipe.treadling.push_back(cloth.of(back ? most - 1 - i : i, p % cloth.n()));
    }
  Design design = with_layer_sett(make_design(recipe, size), ratio, most);
  // One shuttle weaves a tube and a folded cloth.
  return kind == DoubleCloth::kLayers ? with_layer_colors(std::move(design), recipe.treadling, most) : design;
}

Design stitched_cloth(const OverUnder& order, int stitches, bool from_below, ClothSize size) {
  const OverUnder ratio = order.empty() ? OverUnder{1, 1} : order;
  const BitMatrix weave = layer_weave(ratio);
  const Layers cloth{weave, 2, false};
  const int n = cloth.n(), many = std::clamp(stitches, 1, n);
  Recipe recipe = cloth.recipe();
  for (int p = 0; p < 2 * n; ++p) recipe.treadling.push_back(p);
  std::vector<bool> used(static_cast<size_t>(n), false);
  for (int k = 0; k < many; ++k) {
    const int pick = k * n / many;
    int best = -1;
    for (int end = 0; end < n; ++end)
      if (!used[static_cast<size_t>(end)] &&
          (best < 0 || hidden(weave, pick, end, from_below) > hidden(weave, pick, best, from_below)))
        best = end;
    used[static_cast<size_t>(best)] = true;
    std::vector<int>& lifts = recipe.tieup[static_cast<size_t>(cloth.of(from_below ? 0 : 1, pick))];
    if (from_below) lifts.push_back(cloth.of(1, best));
    else std::erase(lifts, cloth.of(0, best));
  }
  Design design = with_layer_sett(make_design(recipe, size), ratio, 2);
  return with_layer_colors(std::move(design), recipe.treadling, 2);
}

}  // namespace weftlight::weaves
