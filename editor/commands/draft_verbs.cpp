// The options of the verbs that read or write drafts.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>

#include "base/text.h"
#include "collection/colour_names.h"
#include "commands/commands.h"
#include "commands/file_options.h"
#include "commands/option_checks.h"
#include "commands/verbs.h"

namespace weftlight::commands {

using base::arg, base::fill, base::mark, base::message, base::tr;
using draft::BitMatrix, draft::kMaxShafts, draft::kMaxThreads;

namespace {

RunVerb add_info(CLI::App& verb) {
  const auto options = std::make_shared<InfoOptions>();
  verb.add_option("file", options->file, tr("Draft: .wif, .dtx, .wpo, or a picture"))->required()->check(input_file());
  verb.add_flag("--json", options->json, tr("Output as JSON"));
  return [options] { return info_command(*options); };
}

RunVerb add_analyse(CLI::App& verb) {
  const auto options = std::make_shared<AnalyseOptions>();
  AnalyseOptions& o = *options;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_flag("--json", o.json, tr("Output as JSON"));
  verb.add_option("--floats", o.float_limit,
                  tr("Longest float allowed, in threads; longer ones are listed; default: 7"))
      ->check(whole_number(0, kMaxThreads));
  add_plan_options(verb, o.plan);
  return [options] { return analyse_command(*options); };
}

CLI::Validator span_into(collection::Span& span) {
  return CLI::Validator(
      [&span](const std::string& text) -> std::string {
        const std::optional<collection::Span> read = collection::span_from(text);
        if (!read) return fill(tr("'{text}' is neither a number nor a range such as 4-8"), arg("text", text));
        span = *read;
        return {};
      },
      "N|N-N");
}

template <class Names>
std::vector<std::string> ids_of(const Names& names) {
  std::vector<std::string> ids;
  for (const auto& name : names) ids.emplace_back(name.id);
  return ids;
}

RunVerb add_find(CLI::App& verb) {
  struct Options {
    FindOptions find;
    std::vector<std::string> words, colours;
    std::string family;
  };
  const auto options = std::make_shared<Options>();
  collection::DraftQuery& q = options->find.query;
  verb.add_option("folder", options->find.folder, tr("Folder of drafts, including subfolders"))->required();
  verb.add_option("words", options->words, tr("Words in title, author or path; all must match"));
  const auto range = [&verb](const char* name, collection::Span& span, const char* description) {
    verb.add_option_function<std::string>(
            name, [](const std::string&) {}, description)
        ->check(span_into(span));
  };
  range("--shafts", q.shafts, tr("Number of shafts, or a range: 8, 4-8, -16; default: any"));
  range("--treadles", q.treadles, tr("Number of treadles, or a range; default: any"));
  range("--ends", q.ends, tr("Number of ends, or a range; default: any"));
  verb.add_option("--family", options->family, tr("Weave family, found by analysis; default: any"))
      ->check(one_of(ids_of(analysis::kWeaveFamilyNames)));
  verb.add_option("--color", options->colours,
                  tr("Colour of at least a twentieth of the threads; may be given several times; default: any"))
      ->allow_extra_args(false)
      ->check(one_of(ids_of(collection::kColourNames)));
  verb.add_flag("--json", options->find.json, tr("Output as JSON"));
  verb.add_flag("--fresh", options->find.fresh, tr("Read every file, and keep no index in the cache"));
  return [options] {
    FindOptions& find = options->find;
    for (const std::string& word : options->words) find.query.words += word + " ";
    if (!options->family.empty()) find.query.family = analysis::family_of_id(options->family);
    for (const std::string& id : options->colours) find.query.colours |= uint32_t{1} << *collection::colour_of_id(id);
    return find_command(find);
  };
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The options of `print` whose values are words.
struct PrintWords {
  std::string paper = "a4", end1 = "right", pick1 = "top", threading = "above";
  std::vector<std::string> parts;  // empty: all
  bool across = false;
};

void add_print_words(CLI::App& verb, PrintWords& words) {
  std::vector<std::string> papers, parts;
  for (const print::NamedPaper& paper : print::kPapers) papers.push_back(lower(paper.name));
  for (const print::NamedPart& part : print::kParts) parts.emplace_back(part.name);
  verb.add_option("--parts", words.parts, tr("Parts to print, separated by commas; default: all"))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(parts));
  verb.add_option("--paper", words.paper, tr("Paper size; default: a4"))->check(one_of(papers));
  verb.add_flag("--across", words.across, tr("Landscape orientation"));
  verb.add_option("--end1", words.end1, tr("Side of end 1; default: right"))->check(one_of({"left", "right"}));
  verb.add_option("--pick1", words.pick1, tr("Side of pick 1; default: top"))->check(one_of({"top", "bottom"}));
  verb.add_option("--threading", words.threading,
                  tr("Position of the threading relative to the drawdown; default: above"))
      ->check(one_of({"above", "below"}));
}

void apply_print_words(print::PrintOptions& o, const PrintWords& words) {
  for (const print::NamedPaper& paper : print::kPapers)
    if (lower(paper.name) == words.paper) o.paper = paper.paper;
  if (words.across) std::swap(o.paper.width_mm, o.paper.height_mm);
  o.end1_right = words.end1 == "right";
  o.pick1_bottom = words.pick1 == "bottom";
  o.threading_below = words.threading == "below";
  for (const print::NamedPart& part : print::kParts)
    o.parts.*part.on = words.parts.empty() || std::ranges::count(words.parts, part.name) > 0;
}

RunVerb add_print(CLI::App& verb) {
  struct Options {
    PrintCommand command;
    PrintWords words;
  };
  const auto options = std::make_shared<Options>();
  print::PrintOptions& o = options->command.options;
  verb.add_option("file", options->command.file, tr("Draft"))->required()->check(input_file());
  verb.add_option("-o,--output", options->command.out, tr("Output file: .pdf, .svg or .png"))
      ->required()
      ->check(output_file({{".pdf", ".svg", ".png"}, true}));
  add_print_words(verb, options->words);
  add_units(verb, o.units);
  verb.add_option("--scale", o.cell_mm, tr("Side of a grid cell in mm; default: chosen to fit the paper"))
      ->check(number_in(0.5, 20.0));
  verb.add_option("--heavy", o.heavy_lines, tr("Threads from one heavier grid line to the next; 0: none; default: 4"))
      ->check(whole_number(0, 1000));
  verb.add_flag("--one-repeat", o.one_repeat, tr("Grids and lists of one repeat only"));
  verb.add_option("--first-sheet", o.first_sheet, tr("First sheet to print; default: 1"))
      ->check(whole_number(1, print::kMaxSheets));
  verb.add_option("--last-sheet", o.last_sheet, tr("Last sheet to print; default: all"))
      ->check(whole_number(1, print::kMaxSheets));
  verb.add_option("--dpi", o.png_dpi, tr("Resolution of a .png in dots per inch; default: 150"))
      ->check(number_in(30.0, 1200.0));
  return [options] {
    apply_print_words(options->command.options, options->words);
    return print_command(options->command);
  };
}

RunVerb add_weave(CLI::App& verb) {
  const auto options = std::make_shared<WeaveOptions>();
  WeaveOptions& o = *options;
  verb.add_option("weave", o.weave, tr("Id of the weave; see --list"));
  verb.add_option("-o,--output", o.out, tr("Output file: .wif; required unless --list is given"))
      ->check(output_file(draft_extensions()));
  verb.add_option("--set", o.set, tr("Parameter of the weave; may be given several times; default: as --list shows"))
      ->type_name(tr("ID=VALUE"));
  verb.add_option("--ends", o.ends, tr("Number of ends; default: 64"))->check(whole_number(1, kMaxThreads));
  verb.add_option("--picks", o.picks, tr("Number of picks; default: 64"))->check(whole_number(1, kMaxThreads));
  verb.add_flag("--list", o.list, tr("List of all weaves with their parameters"));
  return [options] { return weave_command(*options); };
}

RunVerb add_diff(CLI::App& verb) {
  const auto options = std::make_shared<DiffOptions>();
  verb.add_option("a", options->a, tr("First draft"))->required()->check(input_file());
  verb.add_option("b", options->b, tr("Second draft"))->required()->check(input_file());
  return [options] { return diff_command(*options); };
}

RunVerb add_join(CLI::App& verb) {
  const auto options = std::make_shared<JoinOptions>();
  JoinOptions& o = *options;
  verb.add_option("a", o.a, tr("First draft"))->required()->check(input_file());
  verb.add_option("b", o.b, tr("Second draft"))->required()->check(input_file());
  verb.add_option("-o,--output", o.out, tr("Output file: .wif"))->required()->check(output_file(draft_extensions()));
  verb.add_option("--ends", o.ends, tr("Ends taken from each draft in turn, as 2:1; default: not by ends"))
      ->type_name(tr("A:B"));
  verb.add_option("--picks", o.picks, tr("Picks taken from each draft in turn, as 2:1; default: not by picks"))
      ->type_name(tr("A:B"));
  verb.add_option(
          "--layers", o.layers,
          tr("Ends and picks taken from each draft in turn, the first cloth above the second; default: one cloth"))
      ->type_name(tr("A:B"));
  return [options] { return join_command(*options); };
}

RunVerb add_yarns(CLI::App& verb) {
  const auto options = std::make_shared<YarnsOptions>();
  verb.add_option("files", options->files, tr("Drafts, and lists of yarns (.txt)"))->required()->check(input_file());
  verb.add_option("-o,--output", options->out, tr("Output file: a list of all these yarns (.txt); default: printed"))
      ->check(changed_file({{".txt"}}));
  return [options] { return yarns_command(*options); };
}

RunVerb add_drawdown(CLI::App& verb) {
  const auto options = std::make_shared<DrawdownOptions>();
  DrawdownOptions& o = *options;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_flag("--points", o.points, tr("Picture with one pixel per crossing, black where the warp is on top"));
  verb.add_option("-o,--output", o.out,
                  tr("Output file: text, or the coloured drawdown as .png, .jpg, .tif, .svg or .pdf; default: text on "
                     "the standard output"))
      ->check(output_file());
  add_face(verb, o.face);
  verb.add_option_function<std::string>(
          "--end1", [&o](const std::string& side) { o.origin.end1_left = side == "left"; },
          tr("Side of end 1 in the picture; default: right"))
      ->check(one_of({"left", "right"}));
  verb.add_option_function<std::string>(
          "--pick1", [&o](const std::string& side) { o.origin.pick1_bottom = side == "bottom"; },
          tr("Side of pick 1 in the picture; default: top"))
      ->check(one_of({"top", "bottom"}));
  return [options] { return drawdown_command(*options); };
}

/// The weaves of a picture's colours, as "2=satin 8/3".
CLI::Validator weaves_into(std::vector<BitMatrix>& weaves) {
  return CLI::Validator(
      [&weaves](const std::string& text) -> std::string {
        constexpr int kMaxColors = 16;
        const size_t equals = text.find('=');
        const std::string number = text.substr(0, equals);
        const bool digits =
            !number.empty() && number.size() < 3 && number.find_first_not_of("0123456789") == number.npos;
        const int color = digits && equals != std::string::npos ? std::stoi(number) : 0;
        if (color < 1 || color > kMaxColors)
          return fill(
              tr("--weave {text}: give the number of a colour, from 1, the darkest, to {most}, an = and its weave"),
              arg("text", text), arg("most", kMaxColors));
        base::Result<BitMatrix> weave = files::read_weave(text.substr(equals + 1));
        if (!weave) return message(weave.error());
        if (weaves.size() < static_cast<size_t>(color)) weaves.resize(static_cast<size_t>(color));
        weaves[static_cast<size_t>(color) - 1] = std::move(*weave);
        return {};
      },
      "");
}

/// Four whole numbers, "X,Y,W,H".
CLI::Validator crop_into(files::PictureCrop& crop) {
  return CLI::Validator(
      [&crop](const std::string& text) -> std::string {
        files::PictureCrop read;
        char rest = 0;
        if (std::sscanf(text.c_str(), "%6d,%6d,%6d,%6d%c", &read.left, &read.top, &read.width, &read.height, &rest) !=
                4 ||
            read.left < 0 || read.top < 0 || read.width < 1 || read.height < 1)
          return fill(tr("'{text}' is not an area; give left, top, width and height in pixels: 0,0,640,480"),
                      arg("text", text));
        crop = read;
        return {};
      },
      "");
}

void add_picture_draft_options(CLI::App& verb, files::PictureDraft& o) {
  verb.add_option_function<std::string>(
          "--crop", [](const std::string&) {},
          tr("Picture as input: the part to weave, from its upper left corner in pixels; default: all of it"))
      ->type_name("X,Y,W,H")
      ->check(crop_into(o.crop));
  verb.add_option("--picks", o.picks, tr("Picture as input: height of the draft in picks; default: in proportion"))
      ->check(whole_number(2, kMaxThreads));
  verb.add_option_function<std::vector<std::string>>(
          "--weave", [](const std::vector<std::string>&) {},
          tr("Picture as input: the weave of a colour, counted from the darkest: 1=plain, 2=\"twill 2/1\", "
             "3=\"satin 8/3\" (3 of 8 ends up), a code of ISO 9354, or a draft; may be given several times; default: "
             "shaded satins"))
      ->type_name(tr("N=WEAVE"))
      ->allow_extra_args(false)
      ->check(weaves_into(o.weaves))
      ->check(input_file());
  verb.add_flag("--picture-colors", o.own_colors,
                tr("Picture as input: warp in its darkest and weft in its lightest colour; default: black and white"));
  verb.add_option("--ends", o.ends, tr("Picture as input: width of the draft in ends; default: one end per pixel"))
      ->check(whole_number(2, kMaxShafts));
  verb.add_option("--colors", o.colors,
                  tr("Picture as input: number of colours, each woven with a weave of its own; default: two become "
                     "crossings, more "
                     "are reduced to at most eight"))
      ->check(whole_number(2, 16));
  verb.add_option("--floats", o.longest_float,
                  tr("Picture as input: longest float of its weaves in threads; default: 7"))
      ->check(whole_number(1, 1000));
}

RunVerb add_convert(CLI::App& verb) {
  const auto options = std::make_shared<ConvertOptions>();
  ConvertOptions& o = *options;
  verb.add_option("in", o.in, tr("Draft: .wif, .dtx, .wpo, or a picture"))->required()->check(input_file());
  verb.add_option("out", o.out, tr("Output file: .wif"))->required()->check(changed_file(draft_extensions()));
  verb.add_flag("--plain", o.plain, tr("Plain WIF for other programs and loom consoles"));
  auto* liftplan = verb.add_flag_callback(
      "--liftplan", [&o] { o.shed_control = ConvertShedControl::kLiftplan; }, tr("Liftplan as the shed control"));
  verb.add_flag_callback(
          "--treadling", [&o] { o.shed_control = ConvertShedControl::kTreadling; },
          tr("Tie-up and treadling as the shed control"))
      ->excludes(liftplan);
  auto* shafts = verb.add_option("--shafts", o.loom.shafts, tr("Number of shafts that the loom has; default: any"))
                     ->check(whole_number(1, kMaxShafts));
  auto* treadles =
      verb.add_option("--treadles", o.loom.treadles, tr("Number of treadles that the loom has; default: any"))
          ->check(whole_number(1, kMaxShafts))
          ->excludes(liftplan);
  verb.add_flag("--turned", o.turned, tr("Turn the cloth by a quarter, so that warp becomes weft"));
  verb.add_flag("--tidy", o.tidy, tr("Merge identical colours and yarns, and remove unused ones"));
  verb.add_option("--take-version", o.version,
                  tr("Version or colourway of the draft to copy; default: the current draft"))
      ->type_name(tr("NAME"));
  verb.add_flag("--closest", o.closest, tr("Closest weave for the loom, where the draft itself does not fit it"));
  verb.add_flag("--nearest", o.closest)->group("");  // the earlier name
  add_picture_draft_options(verb, o.picture);
  return [options, shafts, treadles] {
    if (!options->closest || shafts->count() + treadles->count() > 0) return convert_command(*options);
    return refuse(tr("--closest: give the loom's --shafts or --treadles with it"));
  };
}

constexpr Verb kDraftVerbs[] = {
    {"info", mark("Print the counts, floats, repeat and warnings of a draft"), add_info},
    {"find", mark("Find the drafts of a folder by shafts, weave, colours and words"), add_find},
    {"analyse", mark("Analyse the floats, layers, repeat, heddles, sett and yarn of a draft"), add_analyse},
    {"print", mark("Print a draft on paper: grids, lists for the loom, swatch"), add_print},
    {"weave", mark("Generate a draft from the table of weaves"), add_weave},
    {"diff", mark("Compare two drafts"), add_diff},
    {"join", mark("Join two drafts in one cloth"), add_join},
    {"yarns", mark("List the yarns of drafts, or write them as a list for the yarn library"), add_yarns},
    {"drawdown", mark("Write the drawdown as text or as a coloured picture"), add_drawdown},
    {"convert", mark("Copy a draft, to the byte unless an option changes it"), add_convert},
};

}  // namespace

std::span<const Verb> draft_verbs() { return kDraftVerbs; }

}  // namespace weftlight::commands
