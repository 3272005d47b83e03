#include "app/handbook.h"

#include <string>

#include "base/resources.h"
#include "base/text.h"
#include "platform/desktop.h"

namespace weftlight::app {

using base::arg, base::fill, base::handbook_page, base::tr;

void show_handbook(Messages& messages) {
  const std::string page = handbook_page();
  if (page.empty())
    return messages.refuse(tr("The handbook is not installed here; its text is in docs/handbook of the source"));
  if (const auto shown = platform::show_page(page); !shown)
    return messages.refuse(fill(tr("No browser was found ({program} is missing). The handbook is {file}"),
                                arg("program", shown.error().program), arg("file", page)));
  messages.say(tr("The handbook opens in the browser"));
}

}  // namespace weftlight::app
