// `response`: the table of the far-field radiance of the flat cloth.

#include <cmath>
#include <fstream>
#include <sstream>

#include "../yarns.h"
#include "design/yarn_presets.h"
#include "scratch_folder.h"
#include "weaves/weaves.h"

namespace weftlight::commands {

using design::Design, design::Fibre, design::Yarn, design::ready_yarn;
using draft::Face;
using weaves::Recipe, weaves::make_design, weaves::plain, weaves::satin, weaves::with_colors, weaves::with_sett;
using wif::write_new_wif;

namespace {

struct Row {
  std::string plane;
  double view = 0, light = 0, r = 0, g = 0, b = 0;
};

double radians(double degrees) { return degrees * 0.017453292519943295; }

class Response : public ScratchFolder {
 protected:
  std::string saved(const Design& design) { return written("cloth.wif", write_new_wif(design)); }
  std::vector<Row> respond(const Design& design, const std::vector<std::string>& options) {
    std::vector<std::string> line{"response", saved(design), "-o", path("out.csv")};
    line.insert(line.end(), options.begin(), options.end());
    const Ran ran = run(line);
    EXPECT_EQ(ran.code, kDone) << ran.said;
    std::ifstream in(path("out.csv"));
    std::string text;
    std::getline(in, text);
    EXPECT_EQ(text, "plane,view_deg,light_deg,r,g,b");
    std::vector<Row> rows;
    while (std::getline(in, text)) {
      std::istringstream fields(text);
      Row row;
      char comma = 0;
      std::getline(fields, row.plane, ',');
      fields >> row.view >> comma >> row.light >> comma >> row.r >> comma >> row.g >> comma >> row.b;
      EXPECT_TRUE(fields) << text;
      rows.push_back(row);
    }
    return rows;
  }
};

/// Straight, round, white, matt threads side by side; all of the warp is on top.
Design white_cylinders() {
  Recipe all_up;
  all_up.shafts = 1, all_up.threading = {0}, all_up.tieup = {{0}}, all_up.treadling = {0};
  Design d = make_design(all_up, {8, 8});
  d.draft.palette = {{1, 1, 1}, {1, 1, 1}};
  Yarn matt;
  matt.diameter_mm = 0.5f, matt.flattening = 1, matt.groove_depth = 0, matt.hairiness = 0;
  matt.lobes.specular = 0, matt.lobes.fuzz = 0, matt.lobes.transmission = 0, matt.lobes.body = 1;
  d = with_yarns(std::move(d), matt, matt);
  d.draft.warp.spacing_mm.assign(8, 0.5f), d.draft.weft.spacing_mm.assign(8, 0.5f);
  return d;
}

/// A warp satin of glossy yarn: red ends, blue picks.
Design two_coloured_satin() {
  Design d = satin(8, 3, Face::kFront, {8, 8});
  d = with_colors(std::move(d), {{0.8f, 0.1f, 0.1f}, {0.1f, 0.1f, 0.8f}}, {{0, 1}}, {{1, 1}});
  Yarn yarn;
  yarn.diameter_mm = 0.3f;
  yarn.lobes.layers = 4, yarn.lobes.inner = 0.2f;
  return with_sett(with_yarns(std::move(d), yarn, yarn));
}

/// Plain weave of the usual linen, nearly white: much of its light goes from thread to thread.
Design white_linen() {
  const Yarn linen = ready_yarn(Fibre::kLinen);
  return with_sett(with_yarns(with_colors(plain({4, 4}), {{0.9f, 0.9f, 0.85f}}, {{0, 1}}, {{0, 1}}), linen, linen));
}

double rms_between(const std::vector<Row>& a, const std::vector<Row>& b) {
  double off = 0, all = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double d = a[i].r - b[i].r;
    off += d * d, all += b[i].r * b[i].r;
  }
  return std::sqrt(off / all);
}

// For a round white cylinder with light and viewer in the plane of its axis, the mean of n.l over the visible side is
// pi / 4 times the cosine of the light; divided by pi for a Lambertian surface.
TEST_F(Response, white_matt_cylinders_reflect_a_quarter_of_the_cosine) {
  for (const char* method : {"cloth", "reference"}) {
    for (const Row& row : respond(
             white_cylinders(), {"--method", method, "--plane", "warp", "--views", "0,40", "--lights", "-60:60:30"})) {
      const double wanted = 0.25 * std::cos(radians(row.light));
      EXPECT_EQ(row.plane, "warp");
      for (const double channel : {row.r, row.g, row.b})
        EXPECT_NEAR(channel, wanted, 0.04 * wanted) << method << ' ' << row.view << ' ' << row.light;
    }
  }
}

TEST_F(Response, the_response_is_reciprocal) {
  for (const char* method : {"cloth", "reference"}) {
    const std::vector<Row> rows = respond(two_coloured_satin(), {"--method", method, "--views", "-50,-20,10,35",
                                                                 "--lights", "-50,-20,10,35", "--spp", "32"});
    ASSERT_EQ(rows.size(), 32u);
    for (size_t i = 0; i < rows.size(); ++i) {
      const size_t plane = i / 16 * 16, view = i % 16 / 4, light = i % 4;
      const Row &row = rows[i], &turned = rows[plane + light * 4 + view];
      // The radiance times the cosine of the viewer is symmetric.
      const double a = row.r * std::cos(radians(row.view)), b = turned.r * std::cos(radians(turned.view));
      EXPECT_NEAR(a / b, 1, 0.12) << method << ' ' << row.plane << ' ' << row.view << ' ' << row.light;
    }
  }
}

TEST_F(Response, the_back_is_the_complement) {
  for (const char* method : {"reference", "repeat"}) {
    const std::vector<std::string> options{"--method", method, "--views", "0,40", "--lights", "-30,20"};
    std::vector<std::string> back = options;
    back.insert(back.end(), {"--face", "back"});
    for (const Row& row : respond(two_coloured_satin(), options)) EXPECT_GT(row.r, 1.5 * row.b) << method;
    for (const Row& row : respond(two_coloured_satin(), back)) EXPECT_GT(row.b, 1.5 * row.r) << method;
  }
}

TEST_F(Response, methods_agree_in_the_far_field) {
  const std::vector<std::string> options{"--views", "0,45", "--lights", "-60:60:20", "--spp", "24", "--method"};
  std::vector<std::vector<Row>> tables;
  for (const char* method : {"reference", "cloth", "repeat", "auto"}) {
    std::vector<std::string> line = options;
    line.push_back(method);
    tables.push_back(respond(two_coloured_satin(), line));
  }
  for (size_t t = 1; t < tables.size(); ++t) {
    ASSERT_EQ(tables[t].size(), tables[0].size());
    EXPECT_LT(rms_between(tables[t], tables[0]), 0.15) << t;
  }
}

// Drawn from afar, samples blurred threads until they hardly reflected light that comes from the other side.
TEST_F(Response, threads_one_by_one_reflect_as_traced_with_light_between_them) {
  const std::vector<std::string> options{"--views", "0,60,80", "--lights", "-60:60:20", "--method"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> line = options;
    line.insert(line.end(), more.begin(), more.end());
    return respond(white_linen(), line);
  };
  const std::vector<Row> traced = with({"reference", "--bounces", "2"});
  EXPECT_LT(rms_between(with({"yarn"}), traced), 0.12);
  EXPECT_LT(rms_between(with({"cloth"}), traced), 0.12);
}

TEST_F(Response, errors_leave_no_files) {
  const std::string draft = fixture_path("twill.wif"), out = path("out.csv");
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
           {},
           {"-o", out, "--method", "magic"},
           {"-o", out, "--plane", "across"},
           {"-o", out, "--views", "0,ninety"},
           {"-o", out, "--views", "0,95"},
           {"-o", out, "--views", "0,,3"},
           {"-o", out, "--lights", "0:80"},
           {"-o", out, "--lights", "80:0:5"},
           {"-o", out, "--lights", "0:80:0"},
           {"-o", out, "--lights", "0:80:1e-9"},
           {"-o", out, "--lights", "nan"},
           {"-o", out, "--spp", "0"},
       }) {
    std::vector<std::string> line{"response", draft};
    line.insert(line.end(), options.begin(), options.end());
    const Ran ran = run(line);
    EXPECT_EQ(ran.code, kUsage) << ::testing::PrintToString(options);
    EXPECT_FALSE(ran.said.empty());
  }
  EXPECT_EQ(run({"response", path("none.wif"), "-o", out}).code, kBadInput);
  EXPECT_EQ(run({"response", draft, "-o", path("no/such/folder/out.csv")}).code, kNotWritten);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace weftlight::commands
