#pragma once
// What the chosen catalogue says of itself.

#include <string>

namespace weftlight::platform {

/// The language of the catalogue that is in use, as "ja"; empty where the texts are the English of the sources.
std::string catalogue_language();

}  // namespace weftlight::platform
