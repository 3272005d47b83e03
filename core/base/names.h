#pragma once
// The folder that every other may use; it uses the names of none.

namespace weftlight {
namespace base {}
}  // namespace weftlight
