#pragma once
// The headless verbs. cli.cpp reads the arguments into these options; one file a verb does the work.
// Verbs print to stdout, problems to stderr as "file:line: what, and what to do".

#include <string>
#include <vector>

#include "analysis/threads.h"
#include "commands/chart/rows.h"
#include "commands/names.h"
#include "draft/design.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "files/picture_draft.h"
#include "print/print.h"
#include "wif/wif.h"

namespace weftlight::commands {

/// The exit codes of the command-line contract.
enum Exit : int { kDone = 0, kUsage = 2, kBadInput = 3, kNoGraphics = 4, kNotWritten = 5 };

struct InfoOptions {
  std::string file;
  bool json = false;
};
/// Which corner of a drawdown begins: end 1 at the right and pick 1 at the top unless said.
struct WayUp {
  bool end1_left = false, pick1_bottom = false;
};
struct DrawdownOptions {
  std::string file, out;
  Face face = Face::kFront;
  bool points = false;  // a picture with a pixel a crossing, as Jacquard machines read
  WayUp way{};          // of a coloured picture
};
enum class ConvertShedControl { kAsIs, kLiftplan, kTreadling };
struct ConvertOptions {
  std::string in, out;
  bool plain = false;
  ConvertShedControl drive = ConvertShedControl::kAsIs;
  draft::LoomSize loom{};  // that it is to fit
  bool nearest = false;    // what does not fit is woven as nearly as it can be
  files::PictureDraft picture{};
};
/// NaN or empty: as the design says.
struct PictureOptions {
  std::string file, out, mesh, method, stats;
  bool simulated_drape = false;  // simulated with the cloth's own stiffness, and kept
  std::string view_name;         // kept with the draft, or one that every draft has; the options below rule over it
  int width = 1280, height = 800;
  float yarns_per_pixel = 0;  // 0: as the scene frames it
  float view_azimuth, view_elevation, light_azimuth, light_elevation;
  Face face = Face::kFront;
  std::string lights;  // of kLightSetups, or a picture from all around; empty: the scene's
  bool surroundings = false;
  float exposure_ev;  // stops; given, it says with automatic_exposure all of the exposure
  bool automatic_exposure = false;
  int turntable = 0;     // render only: pictures of one turn
  int samples = 0;       // render only; 0: as many as the tolerance asks for
  float tolerance = 0;   // render only; 0: the design's
  double budget_ms = 0;  // render only; > 0: as near the truth as the cloth is drawn in so many
  int spp = 64;          // reference only
  int bounces = 0;       // reference only
};
struct ExportOptions {
  std::vector<std::string> files;  // or folders of drafts
  std::vector<std::string> targets{"gltf"};
  std::string out, mesh = "plane";
  std::string name;  // of the folders: {name}, {target}, {size}; empty: as fits
  std::string alpha = "auto";
  int size = 1024, jobs = 1;
  float texels_per_mm = 0;  // 0: as `size` says
  float tile_cm = 0;        // 0: one repeat
  float distance_m = 1;
  std::string mips;  // "dds" or "ktx2": those beside the images; empty: none
  bool force = false, zip = false, watch = false, resume = false;
};
struct ChartOptions {
  std::string out;
  bool quick = false;
  bool count = false;  // instructions too
  chart::ChartPart part;
};
struct ResponseOptions {
  std::string file, out, method = "cloth", plane = "both";  // plane: warp, weft or both
  std::vector<double> views_deg{0, 30, 60}, lights_deg;     // from the normal, within 90
  Face face = Face::kFront;
  int spp = 16;  // reference only: rays in each of a thousand places of the repeat
};
struct DrapeOptions {
  std::string name, out;  // name "all": every shipped drape, however it hangs, into the folder `out`; or a draft
  std::string hang;       // of one drape: limp, medium or stiff; empty: medium, or a draft's own
  std::string mesh;       // of a draft: which drape; empty: its scene's
};

struct AnalyseOptions {
  std::string file;
  bool json = false;
  int float_limit = 7;
  ClothPlan plan;
  std::vector<std::string> prices;  // YARN=PRICE of a kilogram, or PRICE, of all yarns
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

int info_command(const InfoOptions&);
int drawdown_command(const DrawdownOptions&);
int convert_command(const ConvertOptions&);
int render_command(const PictureOptions&);
int reference_command(const PictureOptions&);
int export_command(const ExportOptions&);
int chart_command(const ChartOptions&);
int response_command(const ResponseOptions&);
int drape_command(const DrapeOptions&);
int analyse_command(const AnalyseOptions&);
int diff_command(const DiffOptions&);
int print_command(const PrintCommand&);
int weave_command(const WeaveOptions&);

/// What the command line asks for.
struct EditorOptions {
  std::string file, live_export, ui_map;
};
struct CommandLine {
  bool open_editor = false;  // true: start the window with `editor`; else leave with `exit_code`
  int exit_code = kDone;
  EditorOptions editor;
};
/// Parses and, for a verb, runs it.
CommandLine run_command_line(int argc, char** argv);

/// Shared by the verbs: the file read, its problems printed. Empty when it cannot be used.
struct OpenedDesign {
  bool ok = false;
  Design design;
  WifFile file;
  std::vector<Diagnostic> diagnostics;
};
/// "file:line: what; what to do" on stderr.
void print_diagnostic(const std::string& path, const Diagnostic& diagnostic);
/// "file: cannot be written: cause; what to do" on stderr; kNotWritten.
int not_written(const std::string& why);
/// `picture`: how one becomes a draft.
OpenedDesign open_design(const std::string& path, bool print_warnings = false, const files::PictureDraft& picture = {});

}  // namespace weftlight::commands
