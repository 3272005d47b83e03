#include "views/inspector/words_row.h"

#include "ui/widgets.h"

namespace weftlight::views {

using ui::row_label, ui::tooltip;

void draw_words(const PanelContext& c, const std::string& text, ImU32 color, const char* tip) {
  row_label(c, "", tip);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  tooltip(c, tip);
}

}  // namespace weftlight::views
