#pragma once
// Every folder may use this one; it uses the names of none.

namespace weftlight {
namespace base {}
}  // namespace weftlight
