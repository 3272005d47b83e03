#include "design/thread_order.h"

#include <algorithm>
#include <cstdint>

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Threads, draft::kMaxCells, draft::kMaxThreads;

namespace {

using Order = std::vector<ThreadSource>;

int wrapped(int64_t i, int n) { return static_cast<int>(((i % n) + n) % n); }

Order same_order(int n) {
  Order order(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i) order[static_cast<size_t>(i)].thread = i;
  return order;
}

ThreadRange clipped(const ThreadRange& r, const Draft& d) {
  return {r.system, std::max(r.first, 0), std::min(r.end, d.threads(r.system).size())};
}

BitMatrix in_order(const BitMatrix& m, std::span<const ThreadSource> order) {
  BitMatrix out(static_cast<int>(order.size()), m.cols());
  for (int i = 0; i < out.rows(); ++i)
    if (const ThreadSource& from = order[static_cast<size_t>(i)]; !from.bare)
      std::ranges::copy(m.row(from.thread), out.row(i).begin());
  return out;
}

template <class T>
void put_in_order(std::vector<T>& values, std::span<const ThreadSource> order) {
  std::vector<T> out;
  out.reserve(order.size());
  for (const ThreadSource& from : order) out.push_back(values[static_cast<size_t>(from.thread)]);
  values = std::move(out);
}

void put_in_order(Threads& t, std::span<const ThreadSource> order) {
  put_in_order(t.color, order);
  put_in_order(t.spacing_mm, order);
  put_in_order(t.thickness_mm, order);
  put_in_order(t.yarn, order);
}

/// Each thread keeps its own properties; threads beyond the last have those of the last.
Order properties_in_place(int old_count, size_t count) {
  Order order(count);
  for (size_t i = 0; i < count; ++i) order[i].thread = std::min(static_cast<int>(i), old_count - 1);
  return order;
}

bool is_possible(const Draft& d, System system, std::span<const ThreadSource> order) {
  const int others = system == System::kWarp ? d.picks() : d.ends(), count = d.threads(system).size();
  const auto is_there = [count](const ThreadSource& s) { return s.thread >= 0 && s.thread < count; };
  return !order.empty() && order.size() <= static_cast<size_t>(kMaxThreads) &&
         static_cast<int64_t>(order.size()) * others <= kMaxCells && std::ranges::all_of(order, is_there);
}

/// Thread i of the new order is thread first + source(i - first), for every i within the extent.
template <class Source>
Order over_extent(const ThreadRange& r, int count, RepeatExtent extent, Source source) {
  Order order = same_order(count);
  for (int i = extent == RepeatExtent::kAll ? 0 : r.first; i < count; ++i)
    order[static_cast<size_t>(i)].thread = r.first + source(i - r.first);
  return order;
}

/// Writes row r of `from`, rotated by `step` columns, into `row`.
void rotate_row(std::span<uint64_t> row, const BitMatrix& from, int r, int step) {
  std::ranges::fill(row, 0);
  const int n = from.cols();
  for (int c = 0; c < n; ++c)
    if (from.get(r, c)) {
      const int to = wrapped(int64_t{c} + step, n);
      row[static_cast<size_t>(to >> 6)] |= uint64_t{1} << (to & 63);
    }
}

/// The grid of an advancing repeat: threading, treadling or liftplan.
BitMatrix& advancing_grid(Draft& d, System system) {
  if (system == System::kWarp) return d.threading;
  return d.shed_control == ShedControl::kLiftplan ? d.liftplan : d.treadling;
}

}  // namespace

Design with_thread_order(Design design, System system, std::span<const ThreadSource> order, bool with_properties) {
  Draft& d = design.draft;
  if (!is_possible(d, system, order)) return design;
  if (system == System::kWarp) {
    d.threading = in_order(d.threading, order);
  } else {
    d.treadling = in_order(d.treadling, order);
    d.liftplan = in_order(d.liftplan, order);
  }
  Threads& t = d.threads(system);
  put_in_order(t, with_properties ? Order(order.begin(), order.end()) : properties_in_place(t.size(), order.size()));
  return design;
}

Design with_bare_threads(Design design, System system, int at, int count, bool with_properties) {
  const int n = design.draft.threads(system).size();
  if (n == 0 || count <= 0 || count > kMaxThreads - n) return design;
  at = std::clamp(at, 0, n);
  Order order = same_order(n);
  order.insert(order.begin() + at, static_cast<size_t>(count), {std::min(at, n - 1), true});
  return with_thread_order(std::move(design), system, order, with_properties);
}

Design without_threads(Design design, const ThreadRange& range, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  Order order = same_order(design.draft.threads(r.system).size());
  order.erase(order.begin() + r.first, order.begin() + r.end);
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_doubled_threads(Design design, const ThreadRange& range, bool mirrored, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  Order order = same_order(design.draft.threads(r.system).size());
  Order copy(order.begin() + r.first, order.begin() + r.end);
  if (mirrored) std::ranges::reverse(copy);
  order.insert(order.begin() + r.end, copy.begin() + (mirrored ? 1 : 0), copy.end());
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_reversed_threads(Design design, const ThreadRange& range, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  Order order = same_order(design.draft.threads(r.system).size());
  std::reverse(order.begin() + r.first, order.begin() + r.end);
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_rotated_threads(Design design, const ThreadRange& range, int steps, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  Order order = same_order(design.draft.threads(r.system).size());
  for (int i = r.first; i < r.end; ++i)
    order[static_cast<size_t>(i)].thread = r.first + wrapped(int64_t{i} - r.first - steps, r.count());
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_repeated_threads(Design design, const ThreadRange& range, RepeatExtent extent, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  const Order order =
      over_extent(r, design.draft.threads(r.system).size(), extent, [n = r.count()](int i) { return wrapped(i, n); });
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_point_repeat(Design design, const ThreadRange& range, RepeatExtent extent, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  const int n = r.count(), period = std::max(1, 2 * n - 2);
  const Order order = over_extent(r, design.draft.threads(r.system).size(), extent, [n, period](int i) {
    const int k = wrapped(i, period);
    return k < n ? k : period - k;
  });
  return with_thread_order(std::move(design), r.system, order, with_properties);
}

Design with_advancing_repeat(Design design, const ThreadRange& range, int step, bool with_properties) {
  const ThreadRange r = clipped(range, design.draft);
  if (r.count() <= 0) return design;
  design = with_repeated_threads(std::move(design), r, RepeatExtent::kToEnd, with_properties);
  BitMatrix& grid = advancing_grid(design.draft, r.system);
  if (grid.cols() == 0) return design;
  const int columns = grid.cols();
  for (int i = r.end; i < grid.rows(); ++i) {
    const int64_t repeat = (i - r.first) / r.count();
    rotate_row(grid.row(i), grid, r.first + (i - r.first) % r.count(),
               wrapped(repeat * wrapped(step, columns), columns));
  }
  return design;
}

}  // namespace weftlight::design
