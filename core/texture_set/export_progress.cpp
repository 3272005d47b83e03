#include "texture_set/export_progress.h"

#include "base/text.h"

namespace weftlight::texture_set {

using base::tr;

base::Failure stopped() { return base::failure(base::ErrorKind::kCancelled, tr("stopped")); }

}  // namespace weftlight::texture_set
