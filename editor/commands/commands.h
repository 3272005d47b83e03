#pragma once
// The headless verbs: their options, and the functions that run them. One file a verb; verbs.h is their table.
// Results go to stdout, problems to stderr as "file:line: what; what to do".

#include <string>
#include <vector>

#include "analysis/floats.h"
#include "base/result.h"
#include "chart/chart_rows.h"
#include "collection/query.h"
#include "commands/exit_codes.h"
#include "commands/plan_options.h"
#include "design/design.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "files/picture_draft.h"
#include "print/print.h"

namespace weftlight::commands {

using draft::Face;

struct InfoOptions {
  std::string file;
  bool json = false;
};
struct FindOptions {
  std::string folder;
  collection::DraftQuery query{};
  bool json = false;
  bool fresh = false;  // all files are read, and no index is kept
};
/// The corner of a drawn drawdown at which end 1 and pick 1 meet; by default the top right.
struct DrawdownOrigin {
  bool end1_left = false, pick1_bottom = false;
};
struct DrawdownOptions {
  std::string file, out;
  Face face = Face::kFront;
  bool points = false;      // a picture with one pixel per crossing, the input of Jacquard machines
  DrawdownOrigin origin{};  // of a coloured picture
};
enum class ConvertShedControl { kAsIs, kLiftplan, kTreadling };
struct ConvertOptions {
  std::string in, out;
  bool plain = false;
  ConvertShedControl shed_control = ConvertShedControl::kAsIs;
  draft::LoomSize loom{};  // the size that the result has to fit
  bool closest = false;    // a draft that does not fit is replaced by the closest weave
  bool turned = false;     // by a quarter: warp becomes weft
  bool tidy = false;       // equal colours and yarns are merged, unused ones go
  std::string version{};   // the name of the version to take; empty: the draft as it is
  files::PictureDraft picture{};
};
/// NaN or empty: the design's own value.
struct PictureOptions {
  std::string file, out, mesh, method, stats;
  bool simulated_drape = false;  // simulated with the cloth's own stiffness, and cached
  std::string view_name;         // saved with the draft, or built in; the options below override it
  int width = 1280, height = 800;
  float yarns_per_pixel = 0;  // 0: from the camera of the scene
  float view_azimuth, view_elevation, light_azimuth, light_elevation;
  Face face = Face::kFront;
  std::string lights;         // a lighting preset or the path of an environment map; empty: the scene's
  bool surroundings = false;  // the environment map as the backdrop
  float exposure_ev;          // stops; if given, automatic_exposure is applied too
  bool automatic_exposure = false;
  int turntable = 0;     // render only: number of pictures of one turn
  int samples = 0;       // render only; 0: from the tolerance
  float tolerance = 0;   // render only; 0: the design's
  double budget_ms = 0;  // render only: time for drawing the cloth; 0: no limit
  bool quiet = false;    // no progress
  bool progress_json = false;
  int spp = 64;         // reference only
  int bounces = 2;      // reference only
  bool fibres = false;  // reference only: every fibre instead of threads as tubes
  bool layers = false;  // reference only: depth, normal and others as channels of the .exr
  unsigned seed = 0;    // reference only: another one gives independent noise
};
struct ExportOptions {
  std::vector<std::string> files;  // or folders of drafts
  std::vector<std::string> targets{"gltf"};
  std::string out, mesh = "plane";
  std::string name;  // template of the folders: {name}, {target}, {size}; empty: chosen by the number of targets
  std::string alpha = "auto";
  int size = 1024, jobs = 1;
  float texels_per_mm = 0;  // 0: `size` decides
  float tile_cm = 0;        // 0: as the yarns need
  float distance_m = 1;
  std::string mips;  // format of mipmaps beside the images, a name of kMipFormats; empty: none
  bool force = false, zip = false, watch = false, resume = false;
  bool versions = false;  // a set of each version of a draft, too
  bool quiet = false;     // neither progress nor the folders of the sets
  bool progress_json = false;
};
struct ChartOptions {
  std::string out;
  bool quick = false;
  bool count = false;  // counts instructions too
  chart::ChartSelection part;
};
struct ResponseOptions {
  std::string file, out, method = "cloth", plane = "both";  // plane: warp, weft or both
  std::vector<double> views_deg{0, 30, 60}, lights_deg;     // from the normal, within 90
  Face face = Face::kFront;
  int spp = 16;     // reference and fibres only: rays in each of 1,024 samples of the repeat
  int bounces = 0;  // reference only
};
struct LobesOptions {
  std::string file, out;
  bool fit_lustre = false;
  bool quiet = false, progress_json = false;
};
struct DrapeOptions {
  std::string name, out;  // name: a drape, a draft, or "all": every drape and stiffness, into the folder `out`
  std::string stiffness;  // of a generic fabric: limp, medium or stiff; empty: medium
  std::string mesh;       // of a draft: which drape; empty: its scene's
};

struct CurvesOptions {
  std::string file, out, detail = "plies";                         // threads, plies or fibres
  float width_mm = 10, height_mm = 10, left_mm = 0, lower_mm = 0;  // the patch
  int seed = 1;
};

struct AnalyseOptions {
  std::string file;
  bool json = false;
  int float_limit = analysis::kFloatLimit;
  PlanOptions plan;
};
struct PrintCommand {
  std::string file, out;
  print::PrintOptions options;
};
struct WeaveOptions {
  std::string weave, out;
  std::vector<std::string> set;  // ID=VALUE
  int ends = 64, picks = 64;
  bool list = false;
};
struct DiffOptions {
  std::string a, b;
};
struct JoinOptions {
  std::string a, b, out;
  std::string ends, picks, layers;  // threads of each in turn, as 2:1; one of them is given
};
struct YarnsOptions {
  std::vector<std::string> files;  // drafts, and lists (.txt)
  std::string out;                 // a list; empty: printed
};

int info_command(const InfoOptions&);
int find_command(const FindOptions&);
int drawdown_command(const DrawdownOptions&);
int convert_command(const ConvertOptions&);
int render_command(const PictureOptions&);
int reference_command(const PictureOptions&);
int export_command(const ExportOptions&);
int chart_command(const ChartOptions&);
int response_command(const ResponseOptions&);
int lobes_command(const LobesOptions&);
int drape_command(const DrapeOptions&);
int curves_command(const CurvesOptions&);
int analyse_command(const AnalyseOptions&);
int diff_command(const DiffOptions&);
int join_command(const JoinOptions&);
int print_command(const PrintCommand&);
int weave_command(const WeaveOptions&);
int yarns_command(const YarnsOptions&);

struct CommandLine {
  bool open_editor = false;  // true: start the window with `editor`; false: exit with `exit_code`
  int exit_code = kDone;
  EditorOptions editor;
};
/// The value of --language, wherever it stands; empty if there is none or it is not installed. The caller passes it to
/// platform::use_language before run_command_line, which already prints translated texts.
std::string requested_language(int argc, char** argv);
/// Parses the arguments and runs the verb that they name.
CommandLine run_command_line(int argc, char** argv);

}  // namespace weftlight::commands
