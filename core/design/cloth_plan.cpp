#include "design/cloth_plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

namespace weftlight::design {
namespace {

void limit(float& value, float low, float high, float otherwise) {
  value = std::isnan(value) ? otherwise : std::clamp(value, low, high);
}

bool is_known(const YarnPurchase& p) { return p.cone_g > 0 || p.cone_m > 0 || p.price > 0; }

std::vector<YarnPurchase>::iterator place_of(std::vector<YarnPurchase>& all, std::string_view yarn) {
  return std::ranges::lower_bound(all, yarn, {}, [](const YarnPurchase& p) { return std::string_view(p.yarn); });
}

std::vector<YarnPurchase> clamped(std::vector<YarnPurchase> all) {
  for (YarnPurchase& one : all) {
    limit(one.cone_g, 0, kMaxCone, 0);
    limit(one.cone_m, 0, kMaxCone, 0);
    limit(one.price, 0, kMaxPrice, 0);
  }
  std::erase_if(all, [](const YarnPurchase& p) { return !is_known(p); });
  std::ranges::stable_sort(all, {}, &YarnPurchase::yarn);
  const auto same_name = [](const YarnPurchase& a, const YarnPurchase& b) { return a.yarn == b.yarn; };
  all.erase(std::unique(all.begin(), all.end(), same_name), all.end());
  return all;
}

bool is_sleying(const std::vector<int>& dents) {
  return !dents.empty() && dents.size() <= static_cast<size_t>(kMaxSleyingDents) &&
         std::ranges::all_of(dents, [](int ends) { return ends >= 0 && ends <= kMaxEndsPerDent; }) &&
         std::ranges::any_of(dents, [](int ends) { return ends > 0; });
}

}  // namespace

bool same_shrinkage(const ClothPlan& a, const ClothPlan& b) {
  return a.warp_shrinkage == b.warp_shrinkage && a.weft_shrinkage == b.weft_shrinkage;
}

ClothPlan clamped(ClothPlan plan) {
  const ClothPlan usual;
  for (float ClothPlan::*mm :
       {&ClothPlan::width_mm, &ClothPlan::length_mm, &ClothPlan::fringe_mm, &ClothPlan::loom_waste_mm})
    limit(plan.*mm, 0, kMaxClothMm, usual.*mm);
  for (float ClothPlan::*mm : {&ClothPlan::bout_mm, &ClothPlan::raddle_mm}) limit(plan.*mm, 1, kMaxClothMm, usual.*mm);
  for (float ClothPlan::*part : {&ClothPlan::warp_take_up, &ClothPlan::weft_take_up})
    limit(plan.*part, 0, kMaxTakeUp, usual.*part);
  for (float ClothPlan::*part : {&ClothPlan::warp_shrinkage, &ClothPlan::weft_shrinkage})
    limit(plan.*part, 0, kMaxShrinkage, usual.*part);
  for (float ClothPlan::*sett : {&ClothPlan::ends_per_cm, &ClothPlan::picks_per_cm})
    limit(plan.*sett, 0, kMaxSettPerCm, 0);
  limit(plan.spare, 0, kMaxSpare, usual.spare);
  limit(plan.reed.dents, 0, kMaxDents, 0);
  plan.pieces = std::clamp(plan.pieces, 1, kMaxPieces);
  if (!is_sleying(plan.sleying)) plan.sleying = ClothPlan().sleying;
  plan.purchases = clamped(std::move(plan.purchases));
  return plan;
}

std::string sleying_text(const std::vector<int>& sleying) {
  std::string text;
  for (const int ends : sleying) text.append(text.empty() ? "" : "-").append(std::to_string(ends));
  return text;
}

std::vector<int> sleying_from_text(std::string_view text) {
  std::vector<int> dents;
  const char *at = text.data(), *end = text.data() + text.size();
  while (at != end) {
    if (*at == '-' || *at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    int ends = 0;
    const auto read = std::from_chars(at, end, ends);
    if (read.ec != std::errc() || dents.size() == static_cast<size_t>(kMaxSleyingDents)) return {};
    dents.push_back(ends);
    at = read.ptr;
  }
  return is_sleying(dents) ? dents : std::vector<int>();
}

double ends_per_dent(const std::vector<int>& sleying) {
  if (sleying.empty()) return 0;
  return static_cast<double>(std::accumulate(sleying.begin(), sleying.end(), 0)) / static_cast<double>(sleying.size());
}

YarnPurchase purchase_of(const ClothPlan& plan, std::string_view yarn) {
  for (const YarnPurchase& p : plan.purchases)
    if (p.yarn == yarn) return p;
  return {std::string(yarn), 0, 0, 0};
}

ClothPlan with_purchase(ClothPlan plan, YarnPurchase purchase) {
  auto at = place_of(plan.purchases, purchase.yarn);
  const bool there = at != plan.purchases.end() && at->yarn == purchase.yarn;
  if (!is_known(purchase)) {
    if (there) plan.purchases.erase(at);
  } else if (there) {
    *at = std::move(purchase);
  } else {
    plan.purchases.insert(at, std::move(purchase));
  }
  return plan;
}

}  // namespace weftlight::design
