// Gates of drafts that programs draw wrongly: the back, many threads, uv far from their origin, one thread, none.

#include <algorithm>
#include <array>

#include "gate.h"

namespace weftlight::gl {

using design::Design, design::Look, design::Method, design::Twist, design::method_name;
using draft::Draft, draft::Face, draft::ShedControl, draft::System, draft::Threads, draft::blank_draft;
using drape::Mesh;
using files::Image;
using render_data::Effort, render_data::PackedKind, render_data::PackedTexture, render_data::PreparedMesh,
    render_data::square, render_data::twill;
using scene::bounds_of;

namespace {

constexpr std::array kShadedMethods{Method::kFlat, Method::kVrst03, Method::kCloth,  Method::kRepeat,
                                    Method::kCell, Method::kYarn,   Method::kEngine, Method::kAuto};

/// Warp up on `up` of four picks, so that the two faces differ.
Design faced(int up, Twist twist) {
  Design d = twill(4, up, {0.85f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.8f});
  d.yarns[0].twist = twist;
  d.yarns[0].groove_depth = 0.9f;
  d.look.method = Method::kVrst03;  // its maps too
  return d;
}

Design complemented(Design d) {
  for (int pick = 0; pick < d.draft.picks(); ++pick) {
    for (int shaft = 0; shaft < d.draft.shafts; ++shaft)
      d.draft.liftplan.set(pick, shaft, !d.draft.liftplan.get(pick, shaft));
  }
  return d;
}

TEST_F(Gate, BackIsTheFrontOfTheComplement) {
  scene.sky_strength = 0;
  scene.light_azimuth = 25;
  const auto drawn = [&](Face face, Method method, float yarns) {
    frame.front = face;
    frame.yarns_per_pixel = yarns;
    look.method = method;
    return draw();
  };
  renderer->set_mesh(square(300));
  // A yarn's twist on the back is reversed in the (u, v) of the front.
  const Design ours = faced(3, Twist::kZ), turned = complemented(faced(3, Twist::kS));
  constexpr std::array kFootprints{0.125f, 1.5f};
  std::vector<Image> back, front;
  upload_maps(ours, Effort::kQuick);
  for (const Method method : kShadedMethods) {
    for (const float yarns : kFootprints) {
      back.push_back(drawn(Face::kBack, method, yarns));
      front.push_back(drawn(Face::kFront, method, yarns));
    }
  }
  look.tolerance = 0.03f;  // the noise of few samples is in both, and hides what differs
  const Image yarn_back = drawn(Face::kBack, Method::kYarn, 0.125f);
  look.tolerance = Look{}.tolerance;
  upload_maps(turned, Effort::kQuick);
  size_t at = 0;
  for (const Method method : kShadedMethods) {
    for (const float yarns : kFootprints) {
      const double off = relative_rms(drawn(Face::kFront, method, yarns), back[at]);
      const double ignored = relative_rms(front[at], back[at]);
      ++at;
      figure("back against front of the complement, " + std::string(method_name(method)), ignored, off);
      EXPECT_LT(off, 1e-3) << method_name(method);
    }
  }
  Design same_hand = complemented(faced(3, Twist::kZ));
  same_hand.look.method = Method::kYarn;
  upload_maps(same_hand, Effort::kQuick);
  look.tolerance = 0.03f;
  const double unturned = relative_rms(drawn(Face::kFront, Method::kYarn, 0.125f), yarn_back);
  figure("back of a Z twist, its twist not reversed", unturned, 0);
}

TEST_F(Gate, FromBehindTheComplementIsSeenMirrored) {
  scene.sky_strength = 0;
  frame.yarns_per_pixel = 0.125f;
  renderer->set_mesh(square(40));
  const auto drawn = [&](const Design& d, float view, float light) {
    upload_maps(d, Effort::kQuick);
    scene.view_azimuth = view, scene.light_azimuth = light;
    return draw();
  };
  look.method = Method::kYarn;
  look.tolerance = 0.03f;
  const Image behind = drawn(faced(3, Twist::kZ), 180, 155), front = drawn(complemented(faced(3, Twist::kS)), 0, 25);
  Image mirrored = front;
  for (int y = 0; y < front.height; ++y) {
    for (int x = 0; x < front.width; ++x) {
      const size_t from =
          4 * (static_cast<size_t>(y) * static_cast<size_t>(front.width) + static_cast<size_t>(front.width - 1 - x));
      const size_t to = 4 * (static_cast<size_t>(y) * static_cast<size_t>(front.width) + static_cast<size_t>(x));
      std::copy_n(front.texels.begin() + static_cast<long>(from), 4, mirrored.texels.begin() + static_cast<long>(to));
    }
  }
  figure("seen from behind, not mirrored", relative_rms(front, behind), relative_rms(mirrored, behind));
  EXPECT_LT(relative_rms(mirrored, behind), 0.16);  // sample positions are not mirrored
}

/// A cloth of many threads of which a few are red.
class ManyThreads : public Gate {
 protected:
  void weave(System system, int count, int marker, int marked) {
    const bool warp = system == System::kWarp;
    design.draft = blank_draft(warp ? count : 4, warp ? 4 : count, 4, 4);
    Draft& d = design.draft;
    d.shed_control = ShedControl::kLiftplan;
    d.palette = {{0.8f, 0.8f, 0.75f}, {0.7f, 0.75f, 0.8f}, {0.9f, 0.05f, 0.05f}};
    for (int e = 0; e < d.ends(); ++e) d.threading.set(e, e % 4, true);
    for (int p = 0; p < d.picks(); ++p) {
      for (int s = 0; s < 4; ++s) d.liftplan.set(p, s, ((p + s) % 4 != 0) == warp);
    }
    for (int k = 0; k < marked; ++k) d.threads(system).color[static_cast<size_t>(marker + k)] = 2;
    lay(1, count > 1000 ? Effort::kFull : Effort::kQuick);
  }
  /// Red over green and blue of 4 x 4 yarns around a thread.
  double redness(System system, double thread) {
    const float along = static_cast<float>(thread - 2) * kSpacing;
    const Image image =
        patch(Method::kAuto, 0.25f, 16, system == System::kWarp ? glm::vec2(along, 0) : glm::vec2(0, along));
    return mean(image, 0) / (0.5 * (mean(image, 1) + mean(image, 2)));
  }
};

TEST_F(ManyThreads, PastEachWidthOfANumberKeepTheirColour) {
  // The largest draft has fewer texels than threads, so a band of threads is searched there.
  struct Size {
    int count, past, marked;
  };
  for (const Size& size : {Size{200, 127, 4}, Size{400, 255, 4}, Size{66000, 65535, 96}}) {
    for (const System system : {System::kWarp, System::kWeft}) {
      const int marker = size.past + 60;
      weave(system, size.count, marker, size.marked);
      const double middle = marker + 0.5 * size.marked, narrow = (marker & size.past) + 0.5 * size.marked;
      const double ours = redness(system, middle), fails = redness(system, narrow);
      figure("redness of red threads past " + std::to_string(size.past), fails, ours);
      EXPECT_GT(ours, 3) << size.past;
      EXPECT_LT(redness(system, marker - size.marked), 1.3) << size.past;
    }
  }
}

/// A square with its uv from `uv0` on; `wrapped` false: a point of it that is never drawn holds the origin, so that
/// the card gets the far uv as the floats that they are.
PreparedMesh far_square(float uv0, bool wrapped) {
  PreparedMesh prepared;
  prepared.mesh = square(32, {uv0, uv0});
  if (!wrapped) {
    Mesh& m = prepared.mesh;
    m.position_mm.push_back(m.position_mm[40]);
    m.normal.push_back({0, 0, 1});
    m.tangent.push_back({1, 0, 0});
    m.uv_mm.push_back({0, 0});
  }
  prepared.sky.resize(prepared.mesh.position_mm.size());
  prepared.bounds = bounds_of(prepared.mesh);
  return prepared;
}

TEST_F(Gate, TexturesHoldFarFromTheOriginWhereFloatUvDoesNot) {
  lay(1);
  frame.width = frame.height = 128;
  frame.yarns_per_pixel = 1 / 32.0f;
  scene.sky_strength = 0;
  constexpr float kPeriodMm = kPeriod * kSpacing, kFar = 1e5f * kPeriodMm;  // whole millimetres are floats there
  for (const Method method : {Method::kAuto, Method::kYarn}) {
    look.method = method;
    for (const float within : {0.0f, 1.0f}) {
      const auto drawn = [&](float uv0, bool wrapped) {
        renderer->set_mesh(far_square(uv0, wrapped));
        return draw();
      };
      const Image near = drawn(within, true);
      const double ours = relative_rms(near, drawn(kFar + within, true)),
                   fails = relative_rms(near, drawn(kFar + within, false));
      figure("picture at uv + 1e5 repeats, uv not wrapped, " + std::string(method_name(method)), fails, ours);
      EXPECT_LT(ours, 0.005);
    }
  }
}

TEST_F(Gate, OddDraftsAreClothInEveryMethod) {
  struct Odd {
    const char* name;
    int ends, picks;
    int up;
    float thickness;
  };  // up: of every two crossings
  constexpr std::array kOdd{Odd{"one end, one pick", 1, 1, 2, 0.6f}, Odd{"all weft", 8, 6, 0, 0.6f},
                            Odd{"all warp, long floats", 4, 900, 2, 0.6f}, Odd{"no thickness", 4, 4, 1, 0.0f},
                            Odd{"enormous threads", 4, 4, 1, 1e9f}};
  for (const Odd& odd : kOdd) {
    design.draft = blank_draft(odd.ends, odd.picks, 2, 2);
    design.draft.shed_control = ShedControl::kLiftplan;
    design.draft.palette = {{0.85f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.8f}};
    for (int e = 0; e < odd.ends; ++e) design.draft.threading.set(e, e % 2, true);
    for (int p = 0; p < odd.picks; ++p) {
      for (int s = 0; s < 2; ++s) design.draft.liftplan.set(p, s, odd.up == 2 || (odd.up == 1 && (p + s) % 2 == 0));
    }
    for (Threads* t : {&design.draft.warp, &design.draft.weft}) {
      t->spacing_mm.assign(t->color.size(), kSpacing);
      t->thickness_mm.assign(t->color.size(), odd.thickness);
    }
    upload_maps(design, Effort::kQuick);
    for (const Method method : kShadedMethods) {
      if (method == Method::kVrst03) continue;  // its colours mix over the whole cloth
      for (const float yarns : {0.1f, 1.0f, 12.0f}) {
        const Image image = patch(method, yarns, 16);
        for (const float v : image.texels)
          ASSERT_TRUE(std::isfinite(v) && v >= 0) << odd.name << " " << method_name(method);
        EXPECT_LE(mean(image, 3), 1.001) << odd.name;
        if (odd.thickness <= 0) {
          EXPECT_LT(mean(image, 3), 0.01) << odd.name << " " << method_name(method);
          continue;
        }
        EXPECT_GT(mean(image), 0.01) << odd.name << " " << method_name(method) << " " << yarns;
        if (odd.up == 2) {
          EXPECT_GT(mean(image, 0), 2 * mean(image, 2)) << odd.name << " " << method_name(method) << " " << yarns;
        }
        if (odd.up == 0) {
          EXPECT_GT(mean(image, 2), 2 * mean(image, 0)) << odd.name << " " << method_name(method) << " " << yarns;
        }
      }
    }
    // Colour over coverage, since it is stored premultiplied: 0 / 0 for a system that is not visible.
    const PackedTexture& color = stages.packed().front.textures[static_cast<size_t>(PackedKind::kColor)];
    const int last = static_cast<int>(color.levels.size()) - 1;
    const int hidden = odd.up == 2 ? 1 : 0;
    if (odd.up != 1 || odd.thickness <= 0) {
      figure(std::string("colour over coverage of the hidden system, ") + odd.name,
             static_cast<double>(static_cast<float>(color.texel(last, hidden, 0, 0)[0]) /
                                 static_cast<float>(color.texel(last, hidden, 0, 0)[3])),
             0);
    }
  }
}

}  // namespace
}  // namespace weftlight::gl
