#pragma once
namespace weftlight {
namespace draft {}
namespace design {
using namespace draft;
}
namespace weaves {
using namespace design;
}
}  // namespace weftlight
