#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace analysis {}
namespace wif {}
namespace cloth {}
namespace light {}
namespace drape {}
namespace files {}
namespace texture_set {}
namespace reference {}
namespace upload {}
namespace gl {}
namespace commands {
using namespace base;
using namespace draft;
using namespace analysis;
using namespace wif;
using namespace cloth;
using namespace light;
using namespace drape;
using namespace files;
using namespace texture_set;
using namespace reference;
using namespace upload;
using namespace gl;
}  // namespace commands
}  // namespace weftlight
