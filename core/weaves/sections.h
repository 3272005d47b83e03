#pragma once
// Threading and treadling assembled from named sections by an order: a tree of sections with repeat counts, reversed or
// reflected, as text ("A 4x, (B C') 3x, A<>") and as a list of rows. When a section changes, the threads are assembled
// again.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "design/thread_order.h"

namespace weftlight::weaves {

using design::Assembly, design::Design, design::ThreadRange, design::ThreadSection;
using draft::System;

inline constexpr int kMaxOrderDepth = 32;     // nested groups
inline constexpr int kMaxOrderItems = 10000;  // sections and groups of an order, before repeats
inline constexpr size_t kMaxSections = 500, kMaxSectionNameBytes = 40;

/// How the threads of an item follow each other: as they are; from the last to the first (A'); or forth and back (A<>),
/// turning on single threads, so that the first and the last are not repeated, nor where repeats join.
enum class Turn { kForth, kBack, kForthAndBack };

/// A section or a group of items, repeated.
struct OrderItem {
  std::string section;           // its name; empty: a group
  std::vector<OrderItem> items;  // of a group
  int times = 1;                 // 1..kMaxThreads
  Turn turn = Turn::kForth;
  bool operator==(const OrderItem&) const = default;
};

/// Names, brackets, turns right after them, and counts ("4x", "x4", "4"). A count belongs to the section or bracket
/// before it; at the start, after a comma or after an opening bracket to the one after it. Commas and blanks separate.
/// The error says at which character.
base::Result<std::vector<OrderItem>> read_order(std::string_view text);
/// The order as text that read_order gives back.
std::string order_text(const std::vector<OrderItem>& items);

/// A row of the list; `path`: index of the item at each depth, outermost first.
struct OrderRow {
  std::vector<int> path;
  std::string section;  // empty: a group, whose items follow
  int times = 1;
  Turn turn = Turn::kForth;
};
std::vector<OrderRow> order_rows(const std::vector<OrderItem>& items);
/// The item at a path of order_rows, and the list that contains it.
OrderItem& item_at(std::vector<OrderItem>& items, std::span<const int> path);
std::vector<OrderItem>& list_of(std::vector<OrderItem>& items, std::span<const int> path);

/// A valid section name from typed text: no blanks, brackets, commas or signs of turns, and not a count ("4x").
std::string section_name(std::string_view typed);
/// "A", "B" ... "Z", "A2" ...: the first that is not used.
std::string free_section_name(const Assembly& assembly);

const Assembly& assembly_of(const Design& design, System system);
/// A section with the threads of the range. `name`: from section_name.
ThreadSection section_of(const Design& design, const ThreadRange& range, std::string name);
/// Adds the section, or replaces the one of its name.
Assembly with_section(Assembly assembly, ThreadSection section);
/// Number of threads of the order; -1: more than kMaxThreads.
int assembled_threads(const Assembly& assembly, const std::vector<OrderItem>& items);

/// Stores the assembly in the design and assembles its ends (picks). An order without sections leaves the threads
/// unchanged.
base::Result<Design> assembled(Design design, System system, Assembly assembly);

}  // namespace weftlight::weaves
