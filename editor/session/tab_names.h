#pragma once
// How the open drafts are told apart, and what closing them without saving would lose.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "session/session.h"

namespace weftlight::session {

/// Names of all open drafts, in their order: "twill.wif", "Overshot"; with the folder if two files have the same name,
/// and numbered as they were opened if two drafts without a file have: "Untitled 2".
std::vector<std::string> tab_names(const Session& session);
/// The name of an open draft among those of all; empty if it is not open.
std::string tab_name(const Session& session, uint64_t id);
/// A sentence about open drafts with unsaved changes.
std::string loss_text(const Session& session, std::span<const uint64_t> unsaved);

}  // namespace weftlight::session
