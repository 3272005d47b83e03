// There is no Embree (WEFTLIGHT_EMBREE is off), so no fibres are traced that lobes could be fitted to.

#include "render_data/fibre_lobes.h"

#include "base/text.h"

namespace weftlight::render_data {

base::Result<FibreLobes> lobes_of_fibres(const design::Yarn& /*yarn*/, const FibreFit& /*fit*/,
                                         const base::TaskProgress& /*progress*/) {
  return base::failure(base::ErrorKind::kGraphics,
                       base::tr("this build has no ray tracing; the desktop program compares with traced threads"));
}

}  // namespace weftlight::render_data
