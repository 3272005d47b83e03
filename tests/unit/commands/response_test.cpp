// `response`: a table of what the flat cloth sends back.

#include <cmath>
#include <fstream>
#include <sstream>

#include "../yarns.h"
#include "draft/generators.h"
#include "scratch_folder.h"

namespace weftlight::commands {
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

/// Round white matt threads side by side, straight, all of the warp on top.
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

/// Warp satin of a shining yarn: red ends, blue picks.
Design two_coloured_satin() {
  Design d = satin(8, 3, Face::kFront, {8, 8});
  d = with_colors(std::move(d), {{0.8f, 0.1f, 0.1f}, {0.1f, 0.1f, 0.8f}}, {{0, 1}}, {{1, 1}});
  Yarn yarn;
  yarn.diameter_mm = 0.3f;
  yarn.lobes.layers = 4, yarn.lobes.inner = 0.2f;
  return with_sett(with_yarns(std::move(d), yarn, yarn));
}

// Of a round white cylinder the mean of n.l over what is seen is pi / 4 where light and eye lie in the plane of its
// axis, times the cosine of the light; over pi for a Lambertian one.
TEST_F(Response, white_matt_cylinders_send_a_quarter_of_the_cosine) {
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

TEST_F(Response, light_and_eye_may_change_places) {
  for (const char* method : {"cloth", "reference"}) {
    const std::vector<Row> rows = respond(two_coloured_satin(), {"--method", method, "--views", "-50,-20,10,35",
                                                                 "--lights", "-50,-20,10,35", "--spp", "32"});
    ASSERT_EQ(rows.size(), 32u);
    for (size_t i = 0; i < rows.size(); ++i) {
      const size_t plane = i / 16 * 16, view = i % 16 / 4, light = i % 4;
      const Row &row = rows[i], &turned = rows[plane + light * 4 + view];
      // What a unit of the plane sends, times the eye's cosine, is the same both ways.
      const double a = row.r * std::cos(radians(row.view)), b = turned.r * std::cos(radians(turned.view));
      EXPECT_NEAR(a / b, 1, 0.12) << method << ' ' << row.plane << ' ' << row.view << ' ' << row.light;
    }
  }
}

TEST_F(Response, the_back_is_the_complement) {
  for (const char* method : {"cloth", "reference", "repeat"}) {
    const std::vector<std::string> asked{"--method", method, "--views", "0,40", "--lights", "-30,20"};
    std::vector<std::string> behind = asked;
    behind.insert(behind.end(), {"--face", "back"});
    for (const Row& row : respond(two_coloured_satin(), asked)) EXPECT_GT(row.r, 1.5 * row.b) << method;
    for (const Row& row : respond(two_coloured_satin(), behind)) EXPECT_GT(row.b, 1.5 * row.r) << method;
  }
}

TEST_F(Response, methods_agree_on_a_cloth_from_afar) {
  const std::vector<std::string> asked{"--views", "0,45", "--lights", "-60:60:20", "--spp", "64", "--method"};
  std::vector<std::vector<Row>> tables;
  for (const char* method : {"reference", "cloth", "repeat", "auto"}) {
    std::vector<std::string> line = asked;
    line.push_back(method);
    tables.push_back(respond(two_coloured_satin(), line));
  }
  for (size_t t = 1; t < tables.size(); ++t) {
    ASSERT_EQ(tables[t].size(), tables[0].size());
    double off = 0, all = 0;
    for (size_t i = 0; i < tables[0].size(); ++i) {
      const double d = tables[t][i].r - tables[0][i].r;
      off += d * d, all += tables[0][i].r * tables[0][i].r;
    }
    EXPECT_LT(std::sqrt(off / all), 0.15) << t;
  }
}

TEST_F(Response, what_it_cannot_do_leaves_nothing_behind) {
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
