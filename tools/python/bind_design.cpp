// The Design: a value with its grids and tables as arrays.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "design/edits.h"
#include "design/repeat.h"
#include "draft/drawdown.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/texts.h"
#include "wif/wif.h"

namespace weftlight::python {

using design::ClothPlan, design::Design, design::Finish, design::Look, design::Loom, design::Scene, design::Yarn,
    design::is_consistent, design::with_size;
using draft::BitMatrix, draft::Draft, draft::Face, draft::Rgb, draft::ShedControl, draft::Threads, draft::blank_draft,
    draft::complement, draft::drawdown, draft::kMaxColors;

namespace {

/// The counts of a draft.
struct Counts {
  int ends = 1, picks = 1, shafts = 1, treadles = 1;
  bool operator==(const Counts&) const = default;
};
Counts counts_of(const Draft& d) { return {d.ends(), d.picks(), d.shafts, d.treadles}; }

/// The fields that replace() was given, taken from its keywords one by one.
class Changes {
 public:
  explicit Changes(const py::kwargs& given) : left_(given.attr("copy")()) {}

  template <class T>
  std::optional<T> take(const char* name) {
    if (!left_.contains(name)) return std::nullopt;
    const py::object value = left_.attr("pop")(name);
    try {
      return value.cast<T>();
    } catch (const py::cast_error&) {
      throw py::type_error(fmt::format("{} cannot be {}", name, py::repr(value).cast<std::string>()));
    }
  }
  std::optional<BitMatrix> take_grid(const char* name) {
    if (!left_.contains(name)) return std::nullopt;
    const Cells cells = Cells::ensure(left_.attr("pop")(name));
    if (!cells) throw py::error_already_set();
    return matrix_of(cells, name);
  }
  /// After all were taken.
  void check_none_left() const {
    for (const auto& [name, value] : left_)
      throw py::type_error(fmt::format("a design has no field '{}'", name.cast<std::string>()));
  }

 private:
  py::dict left_;
};

/// The grids and tables of a change, and the counts that they ask for.
struct Parts {
  std::optional<BitMatrix> threading, tieup, treadling, liftplan;
  std::optional<Threads> warp, weft;

  static Parts take(Changes& changes) {
    return {changes.take_grid("threading"), changes.take_grid("tieup"),    changes.take_grid("treadling"),
            changes.take_grid("liftplan"),  changes.take<Threads>("warp"), changes.take<Threads>("weft")};
  }
  Counts counts(const Counts& before) const;
  void put(Draft& d) const;
};

/// One count, on which all parts that state it must agree.
class Agreed {
 public:
  Agreed(const char* what, int before) : what_(what), count_(before) {}
  void add(const char* part, int count) {
    if (part_ != nullptr && count != count_)
      bad_value(fmt::format("{} has {} {}, and {} has {}", part_, count_, what_, part, count));
    part_ = part, count_ = count;
  }
  int count() const { return count_; }

 private:
  const char* what_;
  const char* part_ = nullptr;
  int count_;
};

Counts Parts::counts(const Counts& before) const {
  Agreed ends("ends", before.ends), picks("picks", before.picks), shafts("shafts", before.shafts),
      treadles("treadles", before.treadles);
  if (threading) ends.add("threading", threading->rows()), shafts.add("threading", threading->cols());
  if (tieup) treadles.add("tieup", tieup->rows()), shafts.add("tieup", tieup->cols());
  if (treadling) picks.add("treadling", treadling->rows()), treadles.add("treadling", treadling->cols());
  if (liftplan) picks.add("liftplan", liftplan->rows()), shafts.add("liftplan", liftplan->cols());
  if (warp) ends.add("warp", warp->size());
  if (weft) picks.add("weft", weft->size());
  return {ends.count(), picks.count(), shafts.count(), treadles.count()};
}

void Parts::put(Draft& d) const {
  if (threading) d.threading = *threading;
  if (tieup) d.tieup = *tieup;
  if (treadling) d.treadling = *treadling;
  if (liftplan) d.liftplan = *liftplan;
  if (warp) d.warp = *warp;
  if (weft) d.weft = *weft;
}

/// Grids and threads that are not given keep their cells and take on the new counts.
Design with_parts(Design design, const Parts& parts) {
  const Counts wanted = parts.counts(counts_of(design.draft));
  if (!(wanted == counts_of(design.draft)))
    design = with_size(std::move(design), wanted.ends, wanted.picks, wanted.shafts, wanted.treadles);
  if (!(wanted == counts_of(design.draft)))
    bad_value(fmt::format("a draft of {} ends, {} picks, {} shafts and {} treadles is beyond the limits", wanted.ends,
                          wanted.picks, wanted.shafts, wanted.treadles));
  parts.put(design.draft);
  return design;
}

template <class T>
void assign(T& to, std::optional<T> value) {
  if (value) to = std::move(*value);
}

void check_consistent(const Design& design) {
  if (design.yarns.empty()) bad_value("a design has at least one yarn");
  if (design.draft.palette.size() > static_cast<size_t>(kMaxColors))
    bad_value(fmt::format("a palette has at most {} colours", kMaxColors));
  if (!is_consistent(design))
    bad_value(fmt::format("a thread has a colour or a yarn that the design has not: there are {} colours and {} yarns",
                          design.draft.palette.size(), design.yarns.size()));
}

Design replaced(Design design, const py::kwargs& given) {
  Changes changes(given);
  const Parts parts = Parts::take(changes);
  design = with_parts(std::move(design), parts);
  Draft& d = design.draft;
  if (parts.liftplan && !parts.treadling) d.shed_control = ShedControl::kLiftplan;
  if (parts.treadling && !parts.liftplan) d.shed_control = ShedControl::kTreadling;
  assign(d.shed_control, changes.take<ShedControl>("shed_control"));
  assign(d.rising, changes.take<bool>("rising"));
  assign(d.palette, changes.take<std::vector<Rgb>>("palette"));
  assign(design.title, changes.take<std::string>("title"));
  assign(design.author, changes.take<std::string>("author"));
  assign(design.notes, changes.take<std::vector<std::string>>("notes"));
  assign(design.yarns, changes.take<std::vector<Yarn>>("yarns"));
  assign(design.finish, changes.take<Finish>("finish"));
  assign(design.plan, changes.take<ClothPlan>("plan"));
  assign(design.look, changes.take<Look>("look"));
  assign(design.scene, changes.take<Scene>("scene"));
  assign(design.loom, changes.take<Loom>("loom"));
  changes.check_none_left();
  check_consistent(design);
  return design;
}

Design blank(int ends, int picks, int shafts, int treadles) {
  Design design;
  design.draft = blank_draft(1, 1, 1, 1);
  design = with_size(std::move(design), ends, picks, shafts, treadles);
  if (!(counts_of(design.draft) == Counts{ends, picks, shafts, treadles}))
    bad_value(fmt::format("a draft of {} ends, {} picks, {} shafts and {} treadles is beyond the limits", ends, picks,
                          shafts, treadles));
  return design;
}

BitMatrix cells_of(const Design& design, Face face) {
  BitMatrix cells = drawdown(design.draft);
  return face == Face::kFront ? cells : complement(cells);
}

/// (picks, ends, 3): the colour of the thread on top of each crossing.
py::array_t<float> colors_of(const Design& design, Face face) {
  const Draft& d = design.draft;
  const BitMatrix cells = unlocked([&] { return cells_of(design, face); });
  py::array_t<float> colors({d.picks(), d.ends(), 3});
  float* at = colors.mutable_data();
  for (int pick = 0; pick < d.picks(); ++pick)
    for (int end = 0; end < d.ends(); ++end) {
      const int color =
          cells.get(pick, end) ? d.warp.color[static_cast<size_t>(end)] : d.weft.color[static_cast<size_t>(pick)];
      const Rgb& rgb = d.palette[static_cast<size_t>(color)];
      *at++ = rgb.r, *at++ = rgb.g, *at++ = rgb.b;
    }
  return colors;
}

py::array_t<float> palette_of(const Design& design) {
  const auto& palette = design.draft.palette;
  py::array_t<float> colors({static_cast<py::ssize_t>(palette.size()), py::ssize_t{3}});
  float* at = colors.mutable_data();
  for (const Rgb& rgb : palette) *at++ = rgb.r, *at++ = rgb.g, *at++ = rgb.b;
  return colors;
}

std::pair<int, int> repeat_of(const Design& design, bool colors) {
  const auto repeat = unlocked([&] {
    const BitMatrix cells = drawdown(design.draft);
    return colors ? design::design_repeat(design, cells) : design::structure_repeat(cells);
  });
  return {repeat.ends, repeat.picks};
}

std::string shown(const Design& design) {
  const Draft& d = design.draft;
  return fmt::format("<weftlight.Design '{}': {} ends, {} picks, {} shafts, {} treadles>", design.title, d.ends(),
                     d.picks(), d.shafts, d.treadles);
}

using DesignClass = py::class_<Design>;

/// A property of the draft.
template <class Get>
void of_draft(DesignClass& c, const char* name, Get get) {
  c.def_property_readonly(name, [get](const Design& design) { return get(design.draft); });
}

void bind_draft(DesignClass& c) {
  of_draft(c, "ends", [](const Draft& d) { return d.ends(); });
  of_draft(c, "picks", [](const Draft& d) { return d.picks(); });
  of_draft(c, "shafts", [](const Draft& d) { return d.shafts; });
  of_draft(c, "treadles", [](const Draft& d) { return d.treadles; });
  of_draft(c, "rising", [](const Draft& d) { return d.rising; });
  of_draft(c, "shed_control", [](const Draft& d) { return d.shed_control; });
  of_draft(c, "threading", [](const Draft& d) { return array_of(d.threading); });
  of_draft(c, "tieup", [](const Draft& d) { return array_of(d.tieup); });
  of_draft(c, "treadling", [](const Draft& d) { return array_of(d.treadling); });
  of_draft(c, "liftplan", [](const Draft& d) { return array_of(d.liftplan); });
  of_draft(c, "warp", [](const Draft& d) { return d.warp; });
  of_draft(c, "weft", [](const Draft& d) { return d.weft; });
  c.def_property_readonly("palette", &palette_of);
}

void bind_rest(DesignClass& c) {
  c.def_property_readonly("title", [](const Design& d) { return d.title; })
      .def_property_readonly("author", [](const Design& d) { return d.author; })
      .def_property_readonly("notes", [](const Design& d) { return py::tuple(py::cast(d.notes)); })
      .def_property_readonly("yarns", [](const Design& d) { return py::tuple(py::cast(d.yarns)); })
      .def_property_readonly("finish", [](const Design& d) { return d.finish; })
      .def_property_readonly("plan", [](const Design& d) { return d.plan; })
      .def_property_readonly("look", [](const Design& d) { return d.look; })
      .def_property_readonly("scene", [](const Design& d) { return d.scene; })
      .def_property_readonly("loom", [](const Design& d) { return d.loom; });
}

void bind_derived(DesignClass& c) {
  c.def(
       "drawdown",
       [](const Design& design, Face face) { return array_of(unlocked([&] { return cells_of(design, face); })); },
       py::arg("face") = Face::kFront, "(picks, ends) bool: True where the warp is on top of that face.")
      .def(
          "lifts", [](const Design& design) { return array_of(draft::lifts(design.draft)); },
          "(picks, shafts) bool: the shafts that each pick names, through the tie-up or in the liftplan.")
      .def("colors", &colors_of, py::arg("face") = Face::kFront,
           "(picks, ends, 3) float32, sRGB: the colour of the thread on top.")
      .def("repeat", &repeat_of, py::arg("colors") = true, "(ends, picks) of the smallest repeat.");
}

py::object equal(const Design& design, const py::object& other) {
  if (!py::isinstance<Design>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::bool_(design == other.cast<const Design&>());
}

/// A design as bytes: a WIF holds all of it.
auto pickled() {
  return py::pickle([](const Design& design) { return py::bytes(wif::write_new_wif(design)); },
                    [](const py::bytes& bytes) {
                      wif::WifRead read = wif::read_wif(std::string(bytes));
                      return value_of(std::move(read.file)).design;
                    });
}

}  // namespace

py::class_<Design> bind_design(py::module_& module) {
  DesignClass c(module, "Design",
                "A draft with its yarns, finish, plan, look, scene and loom: a value that does not change.");
  c.def(py::init([](const py::kwargs& fields) { return replaced(blank(1, 1, 1, 1), fields); }))
      .def_static("blank", &blank, py::arg("ends"), py::arg("picks"), py::arg("shafts"), py::arg("treadles"),
                  "A draft with empty grids, black warp and white weft.")
      .def("replace", &replaced, "A design with other fields.")
      .def("__eq__", &equal)
      .def("__repr__", &shown)
      .def(pickled());
  bind_draft(c);
  bind_rest(c);
  bind_derived(c);
  return c;
}

}  // namespace weftlight::python
