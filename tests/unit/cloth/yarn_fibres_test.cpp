// The fibres of a thread: their mass, their places, their waves along it.

#include "cloth/yarn_fibres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::cloth {
namespace {

using design::fibre_facts;
using design::fibre_radius_mm;
using design::tex_of;
using design::Twist;
using design::yarn_presets;

FibreThread thread_of(const Yarn& yarn, float length_mm = 20) {
  FibreThread t;
  t.yarn = yarn;
  t.width_mm = t.height_mm = t.diameter_mm = yarn.diameter_mm;
  t.length_mm = length_mm;
  t.seed = 7;
  return t;
}

/// Length of a fibre on a round thread of this yarn, over the length of the thread.
double way_of(const YarnFibres& yarn, const PlyFibre& fibre, float radius_mm, float length_mm) {
  const int steps = 4000;
  const double step = static_cast<double>(length_mm) / steps;
  double way = 0;
  glm::vec2 before = fibre_place(yarn, fibre, 0);
  for (int k = 1; k <= steps; ++k) {
    const glm::vec2 here = fibre_place(yarn, fibre, static_cast<float>(step * k));
    const double aside = static_cast<double>(glm::length(here - before) * radius_mm);
    way += std::sqrt(step * step + aside * aside);
    before = here;
  }
  return way / static_cast<double>(length_mm);
}

TEST(YarnFibres, WeighWhatTheCountSays) {
  for (const Yarn& yarn : yarn_presets()) {
    const FibreThread thread = thread_of(yarn);
    const YarnFibres made = yarn_fibres(thread);
    const double density = fibre_facts(yarn).density_g_cm3;
    double tex = 0;
    const size_t every = made.fibres.size() > 100 ? 5 : 1;
    for (size_t i = 0; i < made.fibres.size(); i += every) {
      const PlyFibre& fibre = made.fibres[i];
      const double area = std::numbers::pi * static_cast<double>(fibre.radius_mm * fibre.radius_mm);
      tex += static_cast<double>(every) * area * way_of(made, fibre, 0.5f * yarn.diameter_mm, thread.length_mm) *
             density * 1000;
    }
    const double wanted = static_cast<double>(tex_of(yarn));
    EXPECT_NEAR(tex / wanted, 1, 0.06) << yarn.name << " of " << made.fibres.size() << " fibres";
    EXPECT_EQ(static_cast<int>(made.fibres.size()), fibre_count(thread));
  }
}

TEST(YarnFibres, FillTheirPliesEvenlyAndStayInTheThread) {
  for (const Yarn& yarn : yarn_presets())
    for (const int plies : {1, 2, 3, 5}) {
      Yarn plied = yarn;
      plied.plies = plies;
      const YarnFibres made = yarn_fibres(thread_of(plied));
      std::vector<int> in_ply(static_cast<size_t>(plies));
      // Places before migration and wandering: as many inside a radius as its area holds.
      int inner = 0;
      for (const PlyFibre& fibre : made.fibres) {
        ++in_ply[static_cast<size_t>(fibre.ply)];
        inner += fibre.place.x < std::sqrt(0.5f);
        for (const float along : {0.0f, 1.3f, 7.7f})
          EXPECT_LE(glm::length(fibre_place(made, fibre, along)), 1.1f) << yarn.name << ' ' << plies;
      }
      for (const int count : in_ply) EXPECT_EQ(count, in_ply[0]);
      if (made.fibres.size() > 60) {
        const auto all = static_cast<double>(made.fibres.size());
        EXPECT_NEAR(inner / all, 0.5, 0.1) << yarn.name << ' ' << plies;
      }
    }
}

TEST(YarnFibres, PliesHaveTheAreaForTheirFibres) {
  // Round fibres fill at most 0.91 of a section; the ready yarns' plies leave room to spare.
  for (const Yarn& yarn : yarn_presets()) {
    if (yarn.lobes.metallic) continue;
    const YarnFibres made = yarn_fibres(thread_of(yarn));
    double fibres = 0;
    for (const PlyFibre& f : made.fibres) fibres += static_cast<double>(f.radius_mm * f.radius_mm);
    const double radius = 0.5 * static_cast<double>(yarn.diameter_mm);
    const double plies = made.plies * static_cast<double>(made.ply_half.x * made.ply_half.y) * radius * radius;
    EXPECT_LT(fibres / plies, 0.91) << yarn.name;
    EXPECT_GT(fibres / plies, 0.4) << yarn.name;
  }
}

TEST(YarnFibres, WindTheWayOfTheTwist) {
  Yarn yarn = yarn_presets()[0];
  yarn.plies = 1;
  yarn.twist = Twist::kZ;
  FibreThread end = thread_of(yarn), pick = end;
  pick.system = System::kWeft;
  // On the visible side Z goes to +across along an end: the angle, counted from +across upwards, falls.
  EXPECT_LT(yarn_fibres(end).fibre_turns_per_mm, 0);
  EXPECT_GT(yarn_fibres(pick).fibre_turns_per_mm, 0);
  EXPECT_NEAR(std::abs(yarn_fibres(end).fibre_turns_per_mm), yarn.turns_per_m / 1000, 0.026);
  end.yarn.plies = 2;
  const YarnFibres plied = yarn_fibres(end);
  EXPECT_LT(plied.ply_turns_per_mm, 0);
  EXPECT_GT(plied.fibre_turns_per_mm, 0) << "singles are twisted the other way";
  end.yarn.twist = Twist::kNone;
  EXPECT_EQ(yarn_fibres(end).ply_turns_per_mm, 0);
}

TEST(YarnFibres, MeetThemselvesAfterThePeriod) {
  for (const Yarn& yarn : yarn_presets()) {
    const FibreThread thread = thread_of(yarn, 11.3f);
    const YarnFibres made = yarn_fibres(thread);
    for (size_t i = 0; i < made.fibres.size(); i += 17) {
      const glm::vec2 a = fibre_place(made, made.fibres[i], 0.4f),
                      b = fibre_place(made, made.fibres[i], 0.4f + thread.length_mm);
      EXPECT_NEAR(glm::length(a - b), 0, 2e-4) << yarn.name;
    }
  }
}

TEST(YarnFibres, HairFollowsTheHairiness) {
  const auto hair = [](const FibreThread& thread) {
    double mm = 0;
    for (const StrayFibre& s : yarn_fibres(thread).strays)
      if (!s.loop) mm += static_cast<double>(s.length_mm);
    return mm / static_cast<double>(thread.length_mm);
  };
  const Yarn &cotton = yarn_presets()[0], &polyester = yarn_presets()[6];
  const double usual = hair(thread_of(cotton, 200));
  EXPECT_GT(usual, 4) << "Uster H of ring-spun cotton";
  EXPECT_LT(usual, 7);
  EXPECT_EQ(hair(thread_of(polyester, 200)), 0);
  FibreThread raised = thread_of(cotton, 200);
  raised.raised = 1;
  EXPECT_GT(hair(raised), 3 * usual);
  const FibreThread thread = thread_of(cotton, 200);
  EXPECT_EQ(static_cast<int>(yarn_fibres(thread).strays.size()), stray_count(thread));
}

TEST(YarnFibres, TheSameSeedMakesTheSameThread) {
  FibreThread thread = thread_of(yarn_presets()[2]);
  const YarnFibres a = yarn_fibres(thread), b = yarn_fibres(thread);
  thread.seed = 8;
  const YarnFibres c = yarn_fibres(thread);
  ASSERT_EQ(a.fibres.size(), b.fibres.size());
  int differ = 0;
  for (size_t i = 0; i < a.fibres.size(); ++i) {
    EXPECT_EQ(fibre_place(a, a.fibres[i], 3), fibre_place(b, b.fibres[i], 3));
    differ += fibre_place(a, a.fibres[i], 3) != fibre_place(c, c.fibres[i], 3);
  }
  EXPECT_GT(differ, static_cast<int>(a.fibres.size()) / 2);
}

}  // namespace
}  // namespace weftlight::cloth
