// The block of physics in U3M: what a program that simulates garments reads of the cloth.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "../files/sheet.h"
#include "../scratch.h"
#include "base/whole_files.h"
#include "sample_set.h"

namespace weftlight::texture_set {

using base::problem_of, base::read_file;
using drape::sheet;

namespace {

using nlohmann::json;

TEST(U3m, PhysicsAreThoseOfTheClothsHandle) {
  const Scratch scratch("u3m");
  const std::string folder = scratch / "set";
  ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options_for(targets::kU3m, 16))), "");
  const json block = json::parse(std::ifstream(folder + "/sample.u3m"))["material"]["physics"];
  EXPECT_EQ(block["devices"]["fab"], "sample_physics.json");
  const json root = json::parse(std::ifstream(folder + "/sample_physics.json"));
  EXPECT_EQ(root["schema"], "1.1");
  EXPECT_TRUE(root["raw_data"].is_null()) << "nothing was measured";
  const json of = root["custom"]["weftlight"];
  const double weight = of["weight_kg_per_m2"], bending = of["bending_n_m"];
  EXPECT_NEAR(block["weight"].get<double>(), 1000 * weight, 1e-9) << "g/m2";
  EXPECT_GT(weight, 0.1);
  EXPECT_LT(weight, 0.8);
  EXPECT_NEAR(of["bending_length_mm"].get<double>(), 1000 * std::cbrt(bending / (weight * 9.81)), 1e-6) << "Peirce";
  EXPECT_LT(of["bias_n_per_m"].get<double>(), of["stretch_n_per_m"].get<double>());
  EXPECT_NE(read_file(folder + "/sample.u3ma").value_or("").find("sample_physics.json"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::texture_set
