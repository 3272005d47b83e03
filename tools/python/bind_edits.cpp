// The edits of core/design as methods of the Design. There an index out of range changes nothing, as a click beside the
// grid does; here it is an IndexError.

#include <pybind11/stl.h>

#include "design/crossings.h"
#include "design/edits.h"
#include "design/loom.h"
#include "design/thread_order.h"
#include "draft/factor.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/texts.h"

namespace weftlight::python {

using design::Design, design::LoomSize, design::RepeatExtent, design::ThreadRange, design::ThreadSource, design::Yarn,
    design::may_paint;
using draft::BitGrid, draft::BitMatrix, draft::ClosestDraft, draft::Rgb, draft::System, draft::kFromYarn,
    draft::kMaxColors, draft::kMaxShafts;

namespace {

using DesignClass = py::class_<Design>;

const char* thread_name(System system) { return system == System::kWarp ? "end" : "pick"; }

void check_thread(const Design& design, System system, int thread) {
  check_index(thread_name(system), thread, design.draft.threads(system).size());
}

/// One thread or many.
std::vector<int> threads_of(const Design& design, System system, const py::object& given) {
  std::vector<int> threads =
      py::isinstance<py::int_>(given) ? std::vector<int>{given.cast<int>()} : indices_of(given, "threads");
  for (const int thread : threads) check_thread(design, system, thread);
  return threads;
}

void check_paintable(const Design& design, BitGrid grid) { value_of(may_paint(design, grid)); }

Design with_threading(const Design& design, int end, int shaft, bool on, bool only) {
  check_index("end", end, design.draft.ends());
  check_index("shaft", shaft, design.draft.shafts);
  check_paintable(design, BitGrid::kThreading);
  return design::with_threading(design, end, shaft, on, only);
}

Design with_tieup(const Design& design, int treadle, int shaft, bool on) {
  check_index("treadle", treadle, design.draft.treadles);
  check_index("shaft", shaft, design.draft.shafts);
  check_paintable(design, BitGrid::kTieup);
  return design::with_tieup(design, treadle, shaft, on);
}

Design with_treadling(const Design& design, int pick, int treadle, bool on, bool only) {
  check_index("pick", pick, design.draft.picks());
  check_index("treadle", treadle, design.draft.treadles);
  check_paintable(design, BitGrid::kTreadling);
  return design::with_treadling(design, pick, treadle, on, only);
}

Design with_liftplan(const Design& design, int pick, int shaft, bool on) {
  check_index("pick", pick, design.draft.picks());
  check_index("shaft", shaft, design.draft.shafts);
  check_paintable(design, BitGrid::kLiftplan);
  return design::with_liftplan(design, pick, shaft, on);
}

void bind_cells(DesignClass& c) {
  c.def("with_threading", &with_threading, py::arg("end"), py::arg("shaft"), py::arg("on") = true,
        py::arg("only") = true, "An end put on a shaft, or taken off it; `only`: and on no other.")
      .def("with_tieup", &with_tieup, py::arg("treadle"), py::arg("shaft"), py::arg("on") = true,
           "A shaft tied to a treadle, or untied.")
      .def("with_treadling", &with_treadling, py::arg("pick"), py::arg("treadle"), py::arg("on") = true,
           py::arg("only") = true, "A treadle for a pick; `only`: and no other.")
      .def("with_liftplan", &with_liftplan, py::arg("pick"), py::arg("shaft"), py::arg("on") = true,
           "A shaft named by a pick; a treadled draft becomes one with a liftplan first.");
}

Design with_thread_color(const Design& design, System system, const py::object& threads, int color) {
  check_index("colour", color, static_cast<int>(design.draft.palette.size()));
  return design::with_thread_color(design, system, threads_of(design, system, threads), color);
}

Design with_thread_yarn(const Design& design, System system, const py::object& threads, int yarn) {
  check_index("yarn", yarn, static_cast<int>(design.yarns.size()));
  return design::with_thread_yarn(design, system, threads_of(design, system, threads), yarn);
}

float length_of(const std::optional<float>& mm) {
  if (mm && !(*mm >= 0 && std::isfinite(*mm))) bad_value("a length is 0 mm or more; None lets it follow from the yarn");
  return mm.value_or(kFromYarn);
}

Design with_thread_thickness(const Design& design, System system, const py::object& threads, std::optional<float> mm) {
  return design::with_thread_thickness(design, system, threads_of(design, system, threads), length_of(mm));
}

Design with_thread_spacing(const Design& design, System system, const py::object& threads, std::optional<float> mm) {
  return design::with_thread_spacing(design, system, threads_of(design, system, threads), length_of(mm));
}

Design with_palette_color(const Design& design, int color, Rgb rgb) {
  check_index("colour", color, static_cast<int>(design.draft.palette.size()));
  return design::with_palette_color(design, color, rgb);
}

Design with_new_palette_color(const Design& design, Rgb rgb) {
  if (design.draft.palette.size() >= static_cast<size_t>(kMaxColors)) bad_value("the palette is full");
  return design::with_new_palette_color(design, rgb);
}

Design with_yarn(const Design& design, int yarn, const Yarn& value) {
  check_index("yarn", yarn, static_cast<int>(design.yarns.size()));
  return design::with_yarn(design, yarn, value);
}

void bind_threads(DesignClass& c) {
  const auto system = py::arg("system"), threads = py::arg("threads");
  c.def("with_thread_color", &with_thread_color, system, threads, py::arg("color"), "A colour of the palette.")
      .def("with_thread_yarn", &with_thread_yarn, system, threads, py::arg("yarn"), "A yarn of the design.")
      .def("with_thread_thickness", &with_thread_thickness, system, threads, py::arg("mm"), "None: from the yarn.")
      .def("with_thread_spacing", &with_thread_spacing, system, threads, py::arg("mm"), "None: from the yarn.")
      .def("with_palette_color", &with_palette_color, py::arg("color"), py::arg("rgb"), "Another colour in its place.")
      .def("with_new_palette_color", &with_new_palette_color, py::arg("rgb"), "One colour more, at the end.")
      .def("with_yarn", &with_yarn, py::arg("yarn"), py::arg("value"), "Another yarn in its place.")
      .def("with_new_yarn", &design::with_new_yarn, py::arg("value"), "One yarn more, at the end.");
}

/// [first, end) of the ends or picks; not empty.
ThreadRange range_of(const Design& design, System system, int first, int end) {
  check_thread(design, system, first);
  check_thread(design, system, end - 1);
  if (first >= end) bad_value("the range of threads is empty");
  return {system, first, end};
}

using RangeEdit = Design (*)(Design design, const ThreadRange& range, bool with_properties);
template <RangeEdit kEdit>
Design edited(const Design& design, System system, int first, int end, bool with_properties) {
  return kEdit(design, range_of(design, system, first, end), with_properties);
}

Design with_thread_order(const Design& design, System system, const py::object& order, bool with_properties) {
  std::vector<ThreadSource> sources;
  for (const int thread : threads_of(design, system, order)) sources.push_back({thread, false});
  Design ordered = design::with_thread_order(design, system, sources, with_properties);
  if (ordered.draft.threads(system).size() != static_cast<int>(sources.size()))
    bad_value("an order has at least one thread, and no more than a draft can have");
  return ordered;
}

Design with_bare_threads(const Design& design, System system, int at, int count, bool with_properties) {
  check_index("place", at, design.draft.threads(system).size() + 1);
  if (count < 1) bad_value("count is 1 or more");
  Design with = design::with_bare_threads(design, system, at, count, with_properties);
  if (with.draft.threads(system).size() != design.draft.threads(system).size() + count)
    bad_value("a draft cannot have so many threads");
  return with;
}

Design without_threads(const Design& design, System system, int first, int end, bool with_properties) {
  const ThreadRange range = range_of(design, system, first, end);
  if (range.count() == design.draft.threads(system).size()) bad_value("a draft keeps at least one thread");
  return design::without_threads(design, range, with_properties);
}

Design doubled(Design design, const ThreadRange& range, bool with_properties) {
  return design::with_doubled_threads(std::move(design), range, false, with_properties);
}
Design mirrored(Design design, const ThreadRange& range, bool with_properties) {
  return design::with_doubled_threads(std::move(design), range, true, with_properties);
}
Design repeated(Design design, const ThreadRange& range, bool with_properties) {
  return design::with_repeated_threads(std::move(design), range, RepeatExtent::kAll, with_properties);
}
Design point_repeated(Design design, const ThreadRange& range, bool with_properties) {
  return design::with_point_repeat(std::move(design), range, RepeatExtent::kAll, with_properties);
}

void bind_order(DesignClass& c) {
  const auto system = py::arg("system"), first = py::arg("first"), end = py::arg("end");
  const auto with_properties = py::arg("with_properties") = true;
  c.def("with_thread_order", &with_thread_order, system, py::arg("order"), with_properties,
        "The ends or picks in another order; a thread may be left out or stand several times.")
      .def("with_bare_threads", &with_bare_threads, system, py::arg("at"), py::arg("count") = 1, with_properties,
           "Empty threads before `at`.")
      .def("without_threads", &without_threads, system, first, end, with_properties,
           "Without the threads [first, end).")
      .def("with_doubled_threads", &edited<doubled>, system, first, end, with_properties, "A copy after the range.")
      .def("with_mirrored_threads", &edited<mirrored>, system, first, end, with_properties,
           "A reversed copy after the range, the thread at the turn once.")
      .def("with_reversed_threads", &edited<design::with_reversed_threads>, system, first, end, with_properties,
           "The range backwards.")
      .def("with_repeated_threads", &edited<repeated>, system, first, end, with_properties,
           "The range again and again over all threads.")
      .def("with_point_repeat", &edited<point_repeated>, system, first, end, with_properties,
           "The range forwards and backwards in turn over all threads.");
}

/// Limits of the loom that were given; those that were not are the design's.
LoomSize loom_of(const Design& design, std::optional<int> shafts, std::optional<int> treadles) {
  LoomSize most = design::loom_size(design);
  if (shafts) most.shafts = *shafts;
  if (treadles) most.treadles = *treadles;
  for (const int count : {most.shafts, most.treadles})
    if (count < 1 || count > kMaxShafts) bad_value("shafts and treadles are 1 to 4096");
  return most;
}

BitMatrix requested(const Design& design, const Cells& cells) {
  BitMatrix wanted = matrix_of(cells, "cells");
  if (wanted.rows() != design.draft.picks() || wanted.cols() != design.draft.ends())
    bad_value("cells have the shape (picks, ends) of the design; with_size() changes it");
  return wanted;
}

Design with_draft(const Design& design, draft::Draft draft) {
  Design out = design;
  out.draft = std::move(draft);
  return out;
}

Design with_drawdown(const Design& design, const Cells& cells, std::optional<int> shafts, std::optional<int> treadles) {
  const LoomSize most = loom_of(design, shafts, treadles);
  const BitMatrix wanted = requested(design, cells);
  return with_draft(design, value_of(unlocked([&] { return draft::with_drawdown(design.draft, wanted, most); })));
}

std::pair<Design, int64_t> closest_drawdown(const Design& design, const Cells& cells, std::optional<int> shafts,
                                            std::optional<int> treadles, const py::object& progress) {
  const LoomSize most = loom_of(design, shafts, treadles);
  const BitMatrix wanted = requested(design, cells);
  ClosestDraft closest = long_call(progress, [&](const base::TaskProgress& task) {
    return draft::closest_drawdown(design.draft, wanted, most, task);
  });
  return {with_draft(design, std::move(closest.draft)), closest.wrong};
}

Design with_size(const Design& design, std::optional<int> ends, std::optional<int> picks, std::optional<int> shafts,
                 std::optional<int> treadles) {
  const draft::Draft& d = design.draft;
  const int e = ends.value_or(d.ends()), p = picks.value_or(d.picks()), s = shafts.value_or(d.shafts),
            t = treadles.value_or(d.treadles);
  Design sized = design::with_size(design, e, p, s, t);
  if (sized.draft.ends() != e || sized.draft.picks() != p || sized.draft.shafts != s || sized.draft.treadles != t)
    bad_value("a draft cannot have this size");
  return sized;
}

void bind_whole(DesignClass& c) {
  const auto none = py::none();
  c.def("with_size", &with_size, py::kw_only(), py::arg("ends") = none, py::arg("picks") = none,
        py::arg("shafts") = none, py::arg("treadles") = none, "Other counts; new threads continue the stripes.")
      .def("with_rising", &design::with_rising, py::arg("rising"), "Rising or sinking shed; the marks stay.")
      .def("with_leading", &design::with_leading, py::arg("leading"), "What leads: threading, liftplan or drawdown.")
      .def("to_liftplan", &design::to_liftplan, "The same cloth by a liftplan.")
      .def("to_treadling", &design::to_treadling, py::arg("most_treadles") = kMaxShafts,
           "The same cloth by tie-up and treadling, one treadle for a pick.")
      .def(
          "to_skeleton",
          [](const Design& design, int treadles_per_pick, const py::object& progress) {
            if (treadles_per_pick < 1) bad_value("treadles_per_pick is 1 or more");
            return long_call(progress, [&](const base::TaskProgress& task) {
              return design::to_skeleton(design, treadles_per_pick, task);
            });
          },
          py::arg("treadles_per_pick") = 2, py::arg("progress") = none, "The same cloth by a skeleton tie-up.")
      .def("with_drawdown", &with_drawdown, py::arg("cells"), py::kw_only(), py::arg("shafts") = none,
           py::arg("treadles") = none, "Threading and lifts factored from a drawdown.")
      .def("closest_drawdown", &closest_drawdown, py::arg("cells"), py::kw_only(), py::arg("shafts") = none,
           py::arg("treadles") = none, py::arg("progress") = none,
           "(design, wrong crossings): the closest weave that the loom can make.")
      .def(
          "with_crossing",
          [](const Design& design, int end, int pick, bool up) {
            check_index("end", end, design.draft.ends());
            check_index("pick", pick, design.draft.picks());
            return value_of(design::painted_cell(design, end, pick, up));
          },
          py::arg("end"), py::arg("pick"), py::arg("up") = true, "A crossing painted, as in the editor's drawdown.");
}

}  // namespace

void bind_edits(DesignClass& design) {
  bind_cells(design);
  bind_threads(design);
  bind_order(design);
  bind_whole(design);
}

}  // namespace weftlight::python
