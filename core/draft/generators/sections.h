#pragma once
// Threading and treadling put together from named sections: a tree of sections with repeat counts, as text ("A 4x,
// (B C) 3x, A") and as a list of rows. When a section changes, the threads are made anew.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"
#include "draft/thread_order.h"

namespace weftlight::draft {

inline constexpr int kDeepestOrder = 32;      // groups in groups
inline constexpr int kMaxOrderItems = 10000;  // sections and groups of an order as it is written
inline constexpr size_t kMaxSections = 500, kLongestSectionName = 40;

/// A section, or a group of them, some times over.
struct OrderItem {
  std::string section;           // its name; empty: a group
  std::vector<OrderItem> items;  // of a group
  int times = 1;                 // 1..kMaxThreads
  bool operator==(const OrderItem&) const = default;
};
struct Order {
  std::vector<OrderItem> items;
  std::string why;  // what could not be read, and where; empty: all was
};

/// Names, brackets and counts: "A 4x", "4x A", "x4" alike; a count behind a section or a bracket is its own, also one
/// before it at the start, after a comma or an opening bracket. Commas and blanks part. Capped, whatever the text.
Order read_order(std::string_view text);
/// The order as text that read_order gives back.
std::string order_text(const std::vector<OrderItem>& items);

/// A line of the list, outermost first; `path`: index at each depth.
struct OrderRow {
  std::vector<int> path;
  std::string section;  // empty: a group, whose items follow
  int times = 1;
};
std::vector<OrderRow> order_rows(const std::vector<OrderItem>& items);
/// The item at a path, which must be one of order_rows; its list, to insert beside it.
OrderItem& item_at(std::vector<OrderItem>& items, std::span<const int> path);
std::vector<OrderItem>& list_of(std::vector<OrderItem>& items, std::span<const int> path);

/// What may be called a section: no blanks, brackets, commas, and nothing that reads as a count ("4x").
std::string section_name(std::string_view typed);
/// "A", "B" ... "Z", "A2" ...: the first that is not taken.
std::string free_section_name(const Assembly& assembly);

const Assembly& assembly_of(const Design& design, System system);
/// The threads as they are now, under a name that section_name made.
ThreadSection section_of(const Design& design, const ThreadRange& range, std::string name);
/// The section added, or in the place of that of its name.
Assembly with_section(Assembly assembly, ThreadSection section);
/// Threads that the order makes, without making them; -1: more than kMaxThreads.
int assembled_threads(const Assembly& assembly, const std::vector<OrderItem>& items);

struct Assembled {
  Design design;    // as it was, where `why` says so
  std::string why;  // what is wrong with the order; empty: it was woven
};
/// The design with the assembly kept in it, and its ends (picks) made by it. An order without sections keeps the
/// threads as they are.
Assembled assembled(Design design, System system, Assembly assembly);

}  // namespace weftlight::draft
