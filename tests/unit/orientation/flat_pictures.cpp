// Drawn drawdowns, paper, thumbnails and the grid of the window.

#include <cstdio>
#include <regex>
#include <sstream>

#include "base/whole_files.h"
#include "command.h"
#include "session/jobs/thumbnail.h"
#include "views/common/cell_image.h"
#include "views/common/overview_image.h"
#include "views/draft/draft_layout.h"
#include "views/draft/grid_draw.h"

namespace weftlight::orientation {

using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;
using files::Image;
using session::DocumentView, session::DrawdownStyle, session::Intents, session::Settings;
using ui::Style, ui::Tip, ui::UiMap, ui::light_colors;

namespace {

struct Corner {
  const char *end1, *pick1;
  bool left, bottom;
};
constexpr Corner kCorners[] = {{"right", "top", false, false},
                               {"right", "bottom", false, true},
                               {"left", "top", true, false},
                               {"left", "bottom", true, true}};

/// White, to be filled.
Image blank(int width, int height) {
  return {width, height, 3, std::vector<float>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3, 1.0f)};
}

void fill(Image& image, double x0, double y0, double x1, double y1, const std::array<float, 3>& color) {
  for (int y = std::max(0, static_cast<int>(y0 + 0.5)); y < std::min(image.height, static_cast<int>(y1 + 0.5)); ++y)
    for (int x = std::max(0, static_cast<int>(x0 + 0.5)); x < std::min(image.width, static_cast<int>(x1 + 0.5)); ++x)
      std::ranges::copy(color, image.texels.begin() + 3 * (ptrdiff_t{y} * image.width + x));
}

/// The rectangles of a drawing, each over those before it.
Image drawing(const std::string& svg) {
  const std::regex path(R"re(fill:rgb\(([\d.]+)%, *([\d.]+)%, *([\d.]+)%\)[^>]* d="([^"]*)")re");
  const std::regex size(R"re(viewBox="0 0 ([\d.]+) ([\d.]+)")re"), number(R"re(-?[\d.]+)re");
  std::smatch box;
  if (!std::regex_search(svg, box, size)) return {};
  Image out = blank(static_cast<int>(std::stod(box[1])), static_cast<int>(std::stod(box[2])));
  for (std::sregex_iterator at(svg.begin(), svg.end(), path), end; at != end; ++at) {
    const std::string d = (*at)[4];
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    int axis = 0;
    for (std::sregex_iterator n(d.begin(), d.end(), number), last; n != last; ++n, axis ^= 1)
      low[axis] = std::min(low[axis], std::stod(n->str())), high[axis] = std::max(high[axis], std::stod(n->str()));
    const auto share = [&](size_t i) { return std::stof((*at)[i]) / 100; };
    fill(out, low[0], low[1], high[0], high[1], {share(1), share(2), share(3)});
  }
  return out;
}

/// A character a crossing, as pixels.
Image text_picture(const std::string& text) {
  Image out{kEnds, kPicks, 1, {}};
  for (const char c : text)
    if (c == '0' || c == '1') out.texels.push_back(c == '1' ? 0.0f : 1.0f);
  if (out.texels.size() != size_t{kEnds} * kPicks) out.texels.clear();
  return out;
}

Image image_of(int width, int height, const std::vector<uint32_t>& rgba) {
  Image out{width, height, 3, {}};
  for (const uint32_t c : rgba)
    for (const int shift : {0, 8, 16}) out.texels.push_back(static_cast<float>(c >> shift & 255) / 255);
  return out;
}

}  // namespace

std::vector<Seen> drawdowns(const Workplace& at, std::string&) {
  std::vector<Seen> out;
  for (const Face face : {Face::kFront, Face::kBack}) {
    const std::string side = face == Face::kFront ? "front" : "back";
    const auto drawn = [&](const std::string& file, std::vector<std::string> more) {
      std::vector<std::string> args{"drawdown", at.draft(), "--face", side, "-o", at.scratch / file};
      args.insert(args.end(), more.begin(), more.end());
      run(args);
      return at.scratch / file;
    };
    const std::string text = base::read_file(drawn("d.txt", {})).value_or("");
    out.push_back(Seen::whole("text " + side, text_picture(text), face, Shows::kPoints).from(true, false));
    for (const char* file : {"points.png", "points.tif"})
      out.push_back(Seen::whole(file + (" " + side), picture(drawn(file, {"--points"})), face, Shows::kPoints));
    for (const Corner& c : kCorners)
      for (const std::string file : {"d.png", "d.tif", "d.svg"}) {
        const std::string path = drawn(file, {"--end1", c.end1, "--pick1", c.pick1});
        Image image = file == "d.svg" ? drawing(base::read_file(path).value_or("")) : picture(path);
        const std::string name = file + " " + side + " " + c.end1 + " " + c.pick1;
        out.push_back(Seen::whole(name, std::move(image), face).from(c.left, c.bottom));
      }
  }
  return out;
}

namespace {

constexpr int kDpi = 254;  // ten pixels a millimetre

Image printed(const Workplace& at, const Corner& c, const std::vector<std::string>& more) {
  std::vector<std::string> args{"print",   at.draft(), "-o",    at.scratch / "sheet.png", "--end1", c.end1,
                                "--pick1", c.pick1,    "--dpi", std::to_string(kDpi)};
  args.insert(args.end(), more.begin(), more.end());
  run(args);
  return picture(at.scratch / "sheet.png");
}

/// A repeat with its upper left corner there, in millimetres.
Seen on_paper(const std::string& name, Image image, double x_mm, double y_mm, double cell_mm, const Corner& c) {
  constexpr double kPixels = kDpi / 25.4;
  Seen s{name + " " + c.end1 + " " + c.pick1, std::move(image)};
  s.x = x_mm * kPixels, s.y = y_mm * kPixels;
  s.width = kEnds * cell_mm * kPixels, s.height = kPicks * cell_mm * kPixels;
  return std::move(s).from(c.left, c.bottom);
}

}  // namespace

std::vector<Seen> printed_drafts(const Workplace& at, std::string&) {
  constexpr double kX = 14, kY = 30, kCell = 5;  // of the drawdown on A4, the threading below it
  std::vector<Seen> out;
  for (const Corner& c : kCorners) {
    Image sheet = printed(at, c, {"--parts", "draft", "--threading", "below", "--scale", "5"});
    out.push_back(on_paper("draft", std::move(sheet), kX, kY, kCell, c));
  }
  return out;
}

std::vector<Seen> printed_swatches(const Workplace& at, std::string&) {
  constexpr double kX = 14, kY = 20, kWidth = 182, kHeight = 60, kThread = 1;  // of the swatch on A4
  std::vector<Seen> out;
  for (const Corner& c : kCorners) {
    const double x = c.left ? kX : kX + kWidth - kEnds * kThread, y = c.bottom ? kY + kHeight - kPicks * kThread : kY;
    out.push_back(on_paper("swatch", printed(at, c, {"--parts", "swatch"}), x, y, kThread, c));
  }
  return out;
}

std::vector<Seen> thumbnails(const Workplace&, std::string&) {
  constexpr int kWidth = 480, kHeight = 300, kCell = 10;  // a cell is as wide as lets 48 stand across
  const session::Thumbnail t = session::thumbnail_of(marked_design(), kWidth, kHeight);
  Seen s{"thumbnail", image_of(t.width, t.height, t.pixels)};
  s.x = kWidth - kEnds * kCell, s.width = kEnds * kCell, s.height = kPicks * kCell;
  return {s};
}

namespace {

using views::CellImage, views::DraftContext, views::DraftLayout, views::FrameNotes, views::PanelContext,
    views::cell_image, views::draft_context, views::draw_drawdown_cells, views::lay_out_draft;

/// What a list of ImGui's draws, triangle by triangle; all are halves of upright rectangles.
Image drawn(const ImDrawList& list, ImVec2 from, int width, int height) {
  Image out = blank(width, height);
  for (int i = 0; i + 5 < list.IdxBuffer.Size; i += 6) {
    const ImDrawVert &a = list.VtxBuffer[list.IdxBuffer[i]], &b = list.VtxBuffer[list.IdxBuffer[i + 2]];
    const auto channel = [&](int shift) { return static_cast<float>(a.col >> shift & 255) / 255; };
    fill(out, static_cast<double>(a.pos.x - from.x), static_cast<double>(a.pos.y - from.y),
         static_cast<double>(b.pos.x - from.x), static_cast<double>(b.pos.y - from.y),
         {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT)});
  }
  return out;
}

/// A list without a window.
struct OwnList {
  OwnList() : context(ImGui::CreateContext()), list(ImGui::GetDrawListSharedData()) {
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID({});
  }
  ~OwnList() {
    list._ClearFreeMemory();
    ImGui::DestroyContext(context);
  }
  OwnList(const OwnList&) = delete;
  OwnList& operator=(const OwnList&) = delete;
  ImGuiContext* context;
  ImDrawList list;
};

Image drawn_cells(const Design& design, const BitMatrix& cells, const DocumentView& view, const Settings& settings,
                  const DraftLayout& l) {
  OwnList own;
  const Style style;
  UiMap map;
  Tip tip;
  std::string focus;
  FrameNotes notes;
  Intents wanted;
  const PanelContext panel{{style, map, tip, focus}, design, cells, 1, settings, notes, wanted};
  const DraftContext c = draft_context(panel, view, nullptr);
  draw_drawdown_cells(&own.list, c, l.drawdown);
  return drawn(own.list, l.drawdown.min(), static_cast<int>(l.drawdown.x.length),
               static_cast<int>(l.drawdown.y.length));
}

}  // namespace

std::vector<Seen> window_drawdowns(const Workplace&, std::string&) {
  const Design design = marked_design();
  const BitMatrix cells = drawdown(design.draft);
  std::vector<Seen> out;
  for (const Face face : {Face::kFront, Face::kBack})
    for (const Corner& corner : kCorners) {
      Settings settings;
      settings.end1_right = !corner.left, settings.pick1_bottom = corner.bottom;
      DocumentView view;
      view.draft.face = face;
      const DraftLayout l = lay_out_draft(design.draft, view.draft, settings, Style{}, {0, 0}, {800, 600});
      const std::string name =
          std::string(face == Face::kFront ? "front " : "back ") + corner.end1 + " " + corner.pick1;
      const CellImage flat =
          cell_image(design, cells, face, DrawdownStyle::kColor, light_colors(), l.drawdown.x, l.drawdown.y);
      out.push_back(Seen::whole("colours " + name, image_of(flat.width, flat.height, flat.pixels), face)
                        .from(corner.left, corner.bottom));
      for (const DrawdownStyle style : {DrawdownStyle::kThreads, DrawdownStyle::kColor}) {
        settings.drawdown_style = style;
        Image image = drawn_cells(design, cells, view, settings, l);
        out.push_back(
            Seen::whole((style == DrawdownStyle::kThreads ? "threads " : "cells ") + name, std::move(image), face)
                .from(corner.left, corner.bottom));
      }
    }
  return out;
}

}  // namespace weftlight::orientation
