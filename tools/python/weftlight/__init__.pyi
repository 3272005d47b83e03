"""Weaving drafts and the cloth they make.

Conventions, which hold everywhere:

- Indices count from 0: end 0 is WIF's end 1, pick 0 is its pick 1. One out of range is an IndexError; so is one below 0.
- Grids are bool arrays with the thread in the first axis: threading (ends, shafts), treadling (picks, treadles),
  liftplan (picks, shafts), tie-up (treadles, shafts), drawdown (picks, ends).
- Lengths are millimetres, angles degrees, colours sRGB of 0 to 1 unless "linear" is said.
- Every value stays as it is: methods that edit return a new one. Arrays that are given out are copies, or cannot be
  written.
- `progress` is called with a share of 0 to 1 and a sentence, on the thread of the call, at last with 1. Where it returns
  False, the call stops and raises Cancelled; what it raises comes out of the call, and so does KeyboardInterrupt. The
  interpreter's lock is free meanwhile.
- Errors: Error for what cannot be read, woven, drawn or written; ValueError and TypeError for arguments; IndexError;
  MemoryError.
"""

import os
from typing import Callable, Final, Literal, Sequence, Union

import numpy as np
import numpy.typing as npt

__version__: Final[str]

System = Literal["warp", "weft"]
Face = Literal["front", "back"]
Color = Union[tuple[float, float, float], Sequence[float], str]
"""(r, g, b) of 0 to 1, or '#RRGGBB'. Given out as a tuple."""
Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[float, str], object]
_Bools = npt.NDArray[np.bool_]
_Floats = npt.NDArray[np.float32]
_Ints = npt.NDArray[np.int32]

LIGHTS: Final[tuple[str, ...]]
"""Ids of the lighting presets, for Scene.lights."""
METHODS: Final[tuple[str, ...]]
"""Names of the shading methods, for Look.method."""
TARGETS: Final[tuple[str, ...]]
"""Ids of the export targets."""

class Error(Exception):
    """What cannot be read, woven, drawn or written. str() is the whole message: "file:line: what is wrong; what to do"."""

    file: str | None
    """The file that it is about."""
    line: int | None
    """The line of that file, from 1."""
    kind: str
    """'input', 'output', 'graphics' or 'cancelled'."""

class Cancelled(Error):
    """Stopped by the progress callback, which returned False. Nothing half-written is left."""

# Values

class Lobes:
    """How a yarn reflects and transmits light. Ranges, units and sources of all parameters: docs/yarns.md."""

    def __init__(self, **fields: object) -> None:
        """Lobes with these fields; the others are the defaults. ValueError: out of range."""
    def replace(self, **fields: object) -> Lobes: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def specular(self) -> float: ...
    @property
    def specular_tint(self) -> tuple[float, float, float]: ...
    @property
    def ior(self) -> float: ...
    @property
    def along_width(self) -> float: ...
    @property
    def across_width(self) -> float: ...
    @property
    def layers(self) -> float: ...
    @property
    def inner(self) -> float: ...
    @property
    def inner_depth(self) -> float: ...
    @property
    def body(self) -> float: ...
    @property
    def fuzz(self) -> float: ...
    @property
    def fuzz_width(self) -> float: ...
    @property
    def transmission(self) -> float: ...
    @property
    def metallic(self) -> bool: ...

class DyedStretch:
    """A stretch of a thread in one colour. Edges are sharp, or it fades evenly into the next stretch."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> DyedStretch: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def threads(self) -> int:
        """Threads that it crosses, 1 to 10,000."""
    @property
    def color(self) -> tuple[float, float, float] | None:
        """None: the thread's own."""
    @property
    def fades(self) -> bool: ...

class Dye:
    """Colours along a thread, from pick 1 or end 1 on: a painted warp, ikat, space-dyed yarn. They repeat."""

    def __init__(self, **fields: object) -> None:
        """ValueError: out of range, more than 64 stretches, or a colour that is not of 8 bits a channel."""
    def replace(self, **fields: object) -> Dye: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def stretches(self) -> list[DyedStretch]:
        """Empty: the thread has one colour."""
    @property
    def shift(self) -> int:
        """Threads by which each thread's sequence starts earlier than that of the thread before."""
    @property
    def scatter(self) -> int:
        """Moves each thread's sequence by at most so many threads to either side, at random."""

class Yarn:
    """A yarn: its construction and its lobes. Ranges and sources: docs/yarns.md."""

    def __init__(self, **fields: object) -> None:
        """A yarn with these fields; the others are those of the default cotton. ValueError: out of range."""
    def replace(self, **fields: object) -> Yarn: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def name(self) -> str: ...
    @property
    def diameter_mm(self) -> float: ...
    @property
    def twist(self) -> Literal["none", "S", "Z"]: ...
    @property
    def turns_per_m(self) -> float: ...
    @property
    def plies(self) -> int: ...
    @property
    def fibre_um(self) -> float: ...
    @property
    def groove_depth(self) -> float: ...
    @property
    def hairiness(self) -> float: ...
    @property
    def flattening(self) -> float: ...
    @property
    def irregularity(self) -> float: ...
    @property
    def unevenness(self) -> float:
        """Coefficient of variation of the mass along the yarn, % (Uster CVm)."""
    @property
    def melange(self) -> float: ...
    @property
    def lobes(self) -> Lobes: ...
    @property
    def tex(self) -> float:
        """Count, g/km; 0: not set, follows from the thickness (tex_of())."""
    @property
    def dye(self) -> Dye:
        """Colours along the thread."""

class Finish:
    """Degrees of finishing, each 0 to 1; they may be combined."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> Finish: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def washed(self) -> float:
        """0: as the cloth comes off the loom, 1: washed, at the sett of the draft."""
    @property
    def raised(self) -> float: ...
    @property
    def mercerised(self) -> float: ...
    @property
    def calendered(self) -> float: ...

class Reed:
    """A reed by the number on its end."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> Reed: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def dents(self) -> float:
        """In 10 cm, or in an inch; 0: none chosen."""
    @property
    def per_inch(self) -> bool: ...

class YarnPurchase:
    """How a yarn of that name is bought: in cones or skeins, or by the kilogram if neither figure is known."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> YarnPurchase: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def yarn(self) -> str: ...
    @property
    def cone_g(self) -> float: ...
    @property
    def cone_m(self) -> float: ...
    @property
    def price(self) -> float:
        """Of a cone or skein, or of a kilogram; 0: not known."""

class ClothPlan:
    """How large the cloth shall be, and how it goes onto the loom. Lengths in mm, of the finished cloth unless said
    otherwise; take-up, shrinkage and spare are fractions. ValueError: a number is out of range."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> ClothPlan: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def width_mm(self) -> float:
        """0: as drafted."""
    @property
    def length_mm(self) -> float:
        """0: as drafted."""
    @property
    def pieces(self) -> int: ...
    @property
    def fringe_mm(self) -> float: ...
    @property
    def loom_waste_mm(self) -> float: ...
    @property
    def warp_take_up(self) -> float: ...
    @property
    def weft_take_up(self) -> float: ...
    @property
    def warp_shrinkage(self) -> float: ...
    @property
    def weft_shrinkage(self) -> float: ...
    @property
    def spare(self) -> float: ...
    @property
    def ends_per_cm(self) -> float:
        """On the loom; 0: what becomes the draft's sett in the finished cloth."""
    @property
    def picks_per_cm(self) -> float: ...
    @property
    def reed(self) -> Reed: ...
    @property
    def sleying(self) -> list[int]:
        """Ends in each dent, repeated over the reed."""
    @property
    def floating_selvedges(self) -> bool: ...
    @property
    def bout_mm(self) -> float: ...
    @property
    def raddle_mm(self) -> float: ...
    @property
    def purchases(self) -> list[YarnPurchase]: ...

class Look:
    """Shading method and exposure."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> Look: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def method(self) -> str:
        """One of METHODS."""
    @property
    def tolerance(self) -> float:
        """Relative RMSE that method 'auto' may reach."""
    @property
    def exposure_ev(self) -> float:
        """Stops."""
    @property
    def automatic_exposure(self) -> bool: ...

class Scene:
    """Mesh, camera and light. Azimuth 0 faces the front of the cloth, elevation 90 is straight above."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> Scene: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def mesh(self) -> str:
        """A shipped drape (plane, sphere, tablecloth, curtain, skirt, tunic, shirt, scarf, cushion) or the path of a
        .glb or .gltf."""
    @property
    def simulated_drape(self) -> bool:
        """Whether the drape of this fabric is simulated (seconds; kept in the user's cache)."""
    @property
    def view_azimuth(self) -> float: ...
    @property
    def view_elevation(self) -> float: ...
    @property
    def view_distance(self) -> float:
        """1 frames the mesh."""
    @property
    def pan_x(self) -> float: ...
    @property
    def pan_y(self) -> float: ...
    @property
    def light_azimuth(self) -> float: ...
    @property
    def light_elevation(self) -> float: ...
    @property
    def light_strength(self) -> float: ...
    @property
    def sky_strength(self) -> float: ...
    @property
    def background(self) -> tuple[float, float, float]: ...
    @property
    def lights(self) -> str:
        """One of LIGHTS, or the path of an environment map (.hdr, .exr)."""
    @property
    def surroundings(self) -> bool: ...

class Loom:
    """What leads while editing, and the limits of the loom."""

    def __init__(self, **fields: object) -> None: ...
    def replace(self, **fields: object) -> Loom: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def leading(self) -> Literal["threading", "liftplan", "drawdown"]: ...
    @property
    def locked(self) -> bool:
        """Whether grids that follow others cannot be edited cell by cell (Error)."""
    @property
    def shafts(self) -> int:
        """Of the loom; 0: unknown."""
    @property
    def treadles(self) -> int: ...
    @property
    def next_pick(self) -> int:
        """The pick that is woven next, from 0."""
    @property
    def next_end(self) -> int:
        """The end that is threaded next, from 0."""
    @property
    def next_dent(self) -> int:
        """The dent that is sleyed next, from 0."""
    @property
    def tabby_between(self) -> bool:
        """Whether a tabby pick comes before each pattern pick."""
    @property
    def at_tabby(self) -> bool:
        """Whether a tabby pick is woven before next_pick."""
    @property
    def second_tabby(self) -> bool:
        """Whether that, or the next tabby pick, is of the second shed: ends 2, 4, 6 ..."""

class Threads:
    """The ends or the picks of a draft: colour, yarn, spacing and thickness of each."""

    def __init__(
        self,
        color: Sequence[int] | _Ints,
        *,
        yarn: int | Sequence[int] | _Ints = 0,
        spacing_mm: float | Sequence[float] | _Floats | None = None,
        thickness_mm: float | Sequence[float] | _Floats | None = None,
    ) -> None:
        """One number for each thread, or one for all. `color`: indices into the palette; `yarn`: into the yarns. A
        length of nan, or None for all, follows from the yarn. ValueError: of another number of threads."""
    def replace(self, **fields: object) -> Threads: ...
    def __eq__(self, other: object) -> bool: ...
    def __len__(self) -> int: ...
    @property
    def color(self) -> _Ints:
        """(n,): indices into Design.palette."""
    @property
    def yarn(self) -> _Ints:
        """(n,): indices into Design.yarns."""
    @property
    def spacing_mm(self) -> _Floats:
        """(n,): centre to centre, the inverse of the sett; nan: from the yarn."""
    @property
    def thickness_mm(self) -> _Floats:
        """(n,): diameter; nan: from the yarn."""

def yarn_presets() -> list[Yarn]:
    """The yarns that come with the program, cotton first."""

def tex_of(yarn: Yarn) -> float:
    """The count of a yarn, g/km: the one that is set, else that of its fibre and diameter."""

# The design

class Design:
    """A draft with its yarns, finish, plan of the cloth, look, scene and loom: a value. It can be compared, pickled and kept; no method
    changes it."""

    def __init__(self, **fields: object) -> None:
        """A design of one end and one pick with replace(**fields): Design(threading=..., tieup=..., treadling=...)."""
    @staticmethod
    def blank(ends: int, picks: int, shafts: int, treadles: int) -> Design:
        """A draft with empty grids, black warp and white weft. ValueError: beyond the limits (100,000 threads, 4,096
        shafts, 2**31 crossings)."""
    def replace(self, **fields: object) -> Design:
        """The design with other fields: threading, tieup, treadling, liftplan (arrays), warp, weft (Threads), palette,
        title, author, notes, yarns, finish, plan, look, scene, loom, rising, shed_control.

        Arrays of another shape change the counts of the draft: grids and threads that are not given keep their cells,
        new threads continue the stripes. A liftplan alone takes over the shed control, and so does a treadling. ValueError:
        shapes that disagree, a thread of a colour or yarn that is not there."""
    def __eq__(self, other: object) -> bool: ...

    @property
    def title(self) -> str: ...
    @property
    def author(self) -> str: ...
    @property
    def notes(self) -> tuple[str, ...]: ...
    @property
    def ends(self) -> int: ...
    @property
    def picks(self) -> int: ...
    @property
    def shafts(self) -> int: ...
    @property
    def treadles(self) -> int: ...
    @property
    def rising(self) -> bool:
        """Whether tie-up and liftplan name the shafts that rise (else those that sink)."""
    @property
    def shed_control(self) -> Literal["treadling", "liftplan"]:
        """What lifts the shafts."""
    @property
    def threading(self) -> _Bools:
        """(ends, shafts)."""
    @property
    def tieup(self) -> _Bools:
        """(treadles, shafts)."""
    @property
    def treadling(self) -> _Bools:
        """(picks, treadles)."""
    @property
    def liftplan(self) -> _Bools:
        """(picks, shafts): as stored. lifts() is what counts, whatever the shed control."""
    @property
    def warp(self) -> Threads: ...
    @property
    def weft(self) -> Threads: ...
    @property
    def palette(self) -> _Floats:
        """(colours, 3), sRGB."""
    @property
    def yarns(self) -> tuple[Yarn, ...]: ...
    @property
    def finish(self) -> Finish: ...
    @property
    def plan(self) -> ClothPlan: ...
    @property
    def look(self) -> Look: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def loom(self) -> Loom: ...

    # What follows from it
    def drawdown(self, face: Face = "front") -> _Bools:
        """(picks, ends): True where the warp is on top of that face. The back is in the same order of ends,
        complemented."""
    def lifts(self) -> _Bools:
        """(picks, shafts): the shafts that each pick names, through tie-up and treadling or in the liftplan."""
    def colors(self, face: Face = "front") -> _Floats:
        """(picks, ends, 3), sRGB: the colour of the thread on top of each crossing. Row 0 is pick 1, column 0 is end 1;
        a cloth is shown with end 1 at the right: [:, ::-1]."""
    def repeat(self, colors: bool = True) -> tuple[int, int]:
        """(ends, picks) of the smallest repeat, with colours and yarns or of the weave alone."""

    # Edits of cells
    def with_threading(self, end: int, shaft: int, on: bool = True, only: bool = True) -> Design:
        """The end on the shaft, or off it; `only`: and on no other."""
    def with_tieup(self, treadle: int, shaft: int, on: bool = True) -> Design: ...
    def with_treadling(self, pick: int, treadle: int, on: bool = True, only: bool = True) -> Design:
        """The treadle for the pick; `only`: and no other."""
    def with_liftplan(self, pick: int, shaft: int, on: bool = True) -> Design:
        """The shaft named by the pick. A treadled draft becomes one with a liftplan first."""
    def with_crossing(self, end: int, pick: int, up: bool = True) -> Design:
        """A crossing painted as in the editor's drawdown: what leads (loom.leading) decides what else changes. Error: the
        loom cannot weave it."""
    def with_drawdown(self, cells: _Bools, *, shafts: int | None = None, treadles: int | None = None) -> Design:
        """Threading and lifts factored from a drawdown (picks, ends), the weaver's numbering kept where it fits. Limits:
        those given, else the loom's, else 32. Error: the loom is too small; the message says what it would take."""
    def closest_drawdown(
        self,
        cells: _Bools,
        *,
        shafts: int | None = None,
        treadles: int | None = None,
        progress: Progress | None = None,
    ) -> tuple[Design, int]:
        """(design, wrong crossings): the closest weave that the loom can make. Seconds for large drafts."""

    # Edits of threads: one index or many
    def with_thread_color(self, system: System, threads: int | Sequence[int] | _Ints, color: int) -> Design: ...
    def with_thread_yarn(self, system: System, threads: int | Sequence[int] | _Ints, yarn: int) -> Design: ...
    def with_thread_thickness(self, system: System, threads: int | Sequence[int] | _Ints, mm: float | None) -> Design:
        """None: from the yarn."""
    def with_thread_spacing(self, system: System, threads: int | Sequence[int] | _Ints, mm: float | None) -> Design:
        """Centre to centre; None: from the yarn."""
    def with_palette_color(self, color: int, rgb: Color) -> Design: ...
    def with_new_palette_color(self, rgb: Color) -> Design: ...
    def with_yarn(self, yarn: int, value: Yarn) -> Design: ...
    def with_new_yarn(self, value: Yarn) -> Design: ...
    def with_thread_order(
        self, system: System, order: Sequence[int] | _Ints, with_properties: bool = True
    ) -> Design:
        """The ends or picks in another order; a thread may be left out or stand several times. With their colour, yarn,
        spacing and thickness, or these stay in place."""
    def with_bare_threads(self, system: System, at: int, count: int = 1, with_properties: bool = True) -> Design:
        """`count` empty threads before `at`, with the properties of the thread there."""
    def without_threads(self, system: System, first: int, end: int, with_properties: bool = True) -> Design:
        """Without the threads [first, end). ValueError: none would be left."""
    def with_doubled_threads(self, system: System, first: int, end: int, with_properties: bool = True) -> Design: ...
    def with_mirrored_threads(self, system: System, first: int, end: int, with_properties: bool = True) -> Design:
        """A reversed copy after the range, the thread at the turn once."""
    def with_reversed_threads(self, system: System, first: int, end: int, with_properties: bool = True) -> Design: ...
    def with_repeated_threads(self, system: System, first: int, end: int, with_properties: bool = True) -> Design:
        """The range again and again over all threads."""
    def with_point_repeat(self, system: System, first: int, end: int, with_properties: bool = True) -> Design:
        """The range forwards and backwards in turn over all threads, as a point draw."""

    # Edits of the whole
    def with_size(
        self,
        *,
        ends: int | None = None,
        picks: int | None = None,
        shafts: int | None = None,
        treadles: int | None = None,
    ) -> Design:
        """New threads continue the stripes, new cells are empty. ValueError: beyond the limits."""
    def with_rising(self, rising: bool) -> Design:
        """Rising or sinking shed; the marks stay, so front and back are exchanged."""
    def with_leading(self, leading: Literal["threading", "liftplan", "drawdown"]) -> Design: ...
    def to_liftplan(self) -> Design:
        """The same cloth by a liftplan."""
    def to_treadling(self, most_treadles: int = 4096) -> Design:
        """The same cloth by tie-up and treadling, one treadle for a pick."""
    def to_skeleton(self, treadles_per_pick: int = 2, progress: Progress | None = None) -> Design:
        """The same cloth by a skeleton tie-up: several treadles at once, fewer in all. Up to seconds."""
    def with_weave(
        self,
        name: str,
        first_end: int = 0,
        end: int | None = None,
        first_pick: int = 0,
        pick: int | None = None,
        **parameters: object,
    ) -> Design:
        """A weave (see weave()) over the ends [first_end, end) and the picks [first_pick, pick); None: to the last. Over
        all threads it replaces threading, tie-up and treadling; over some, only their crossings change, within the loom's
        limits. Error: they do not allow it."""

    # Analysis
    def longest_floats(self) -> LongestFloats: ...
    def long_floats(self, limit: int, most: int = 10000) -> tuple[int, list[Float]]:
        """(count, floats) of more than `limit` threads; the longest `most` are listed."""
    def layers(self) -> list[WeaveLayer]:
        """The layers that the cloth falls apart into, front to back; one for a cloth that holds together."""
    def loom_use(self) -> LoomUse: ...
    def interlacing(self) -> Interlacing: ...
    def firm_sett_per_cm(self, wraps_per_cm: float) -> float:
        """Ends per cm of a firm cloth of yarn with that many wraps (Ashenhurst 1884), its layers one over the other."""
    def handle(self) -> ClothHandle:
        """Weight and bending stiffness, from yarns and sett."""
    def measures(self) -> ClothMeasures:
        """The measures of the cloth of `plan`, on the loom and finished; all 0 for a draft of no size."""
    def yarn_report(self) -> YarnReport:
        """The yarn that the cloth of `plan` takes."""

    # The cloth
    def maps(
        self,
        size: tuple[int, int] = (1024, 1024),
        *,
        face: Face = "front",
        period: Literal["draft", "repeat"] = "repeat",
        azimuths: int = 0,
    ) -> Maps:
        """One period sampled on a seamless grid of size (width, height), each 1 to 16,384; the same bit for bit on any
        number of cores. `azimuths`: of horizons, 0 to 64. It cannot be stopped: about half a second for 1024 x 1024."""
    def response(
        self,
        views_deg: Sequence[float],
        lights_deg: Sequence[float],
        *,
        plane: System = "warp",
        face: Face = "front",
        reference: bool = False,
        spp: int = 16,
        progress: Progress | None = None,
    ) -> _Floats:
        """(views, lights, 3), linear: radiance for unit irradiance of the flat cloth from afar, under one light and
        nothing else; a white Lambertian surface has cos(light) / pi. Angles from the normal, in the plane that holds the
        warp (weft); lights beyond 90 shine from behind. By method 'cloth', or ray traced (`reference`) with `spp` rays in
        each of 1,024 samples."""

    # Files
    def to_wif(self, plain: bool = False) -> bytes:
        """A new WIF. `plain`: for other programs, ASCII and without private sections. An opened draft keeps its own
        lines by DraftFile.to_bytes()."""
    def write(self, path: Path, plain: bool = False) -> None:
        """The same into a file, whole or not at all. Error: it cannot be written."""

# Files

class Diagnostic:
    """What was read with a remark."""

    @property
    def severity(self) -> Literal["note", "warning", "error"]: ...
    @property
    def line(self) -> int | None:
        """From 1; None: the file as a whole."""
    @property
    def text(self) -> str: ...
    @property
    def remedy(self) -> str: ...

class DraftFile:
    """A draft as it was read. Its bytes are kept: unedited it is written back byte for byte, and an edit changes only its
    own lines."""

    @property
    def design(self) -> Design: ...
    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]: ...
    @property
    def format(self) -> Literal["wif", "dtx", "wpo"]: ...
    @property
    def source_program(self) -> str: ...
    @property
    def source_version(self) -> str: ...
    @property
    def version(self) -> str: ...
    @property
    def date(self) -> str: ...
    def to_bytes(self, design: Design | None = None) -> bytes:
        """The bytes of the file, or with `design` in its place. Of a .dtx or .wpo: those of a new WIF."""
    def write(self, path: Path, design: Design | None = None) -> None:
        """The same into a file, whole or not at all. Error: it cannot be written."""

def read(path: Path) -> DraftFile:
    """Reads WIF, Fiberworks (.dtx), WeavePoint (.wpo), or a picture (.png, .tif, .bmp), whose pixels become crossings.
    Error, with file and line: it cannot be used."""

def read_bytes(data: bytes, name: str = "") -> DraftFile:
    """Reads the bytes of a .wif, .dtx or .wpo; `name` is the file of an Error."""

# Weaves

class WeaveParameter:
    @property
    def id(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def tip(self) -> str: ...
    @property
    def kind(self) -> Literal["count", "choice", "text"]: ...
    @property
    def default(self) -> str: ...
    @property
    def low(self) -> int: ...
    @property
    def high(self) -> int: ...
    @property
    def choices(self) -> tuple[str, ...]: ...

class WeaveKind:
    """A weave of the table."""

    @property
    def id(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def family(self) -> str: ...
    @property
    def description(self) -> str: ...
    @property
    def parameters(self) -> tuple[WeaveParameter, ...]: ...

def weaves() -> list[WeaveKind]:
    """Every weave that weave() makes."""

def weave(name: str, size: tuple[int, int] = (64, 64), **parameters: object) -> Design:
    """A new draft of a weave by its id, of size (ends, picks): weave("twill", (32, 24), ratio="3/1"). The parameters are
    kept in the design. ValueError: no such weave, or a value that it cannot have; TypeError: no such parameter. What was
    changed to the nearest value that makes a weave is a UserWarning."""

# Analysis

class LongestFloats:
    """In threads; the draft repeats in both directions."""

    @property
    def warp_front(self) -> int: ...
    @property
    def warp_back(self) -> int: ...
    @property
    def weft_front(self) -> int: ...
    @property
    def weft_back(self) -> int: ...

class Float:
    """`thread` passes over `length` crossing threads from `first` on, around the edge if need be."""

    @property
    def system(self) -> System: ...
    @property
    def face(self) -> Face: ...
    @property
    def thread(self) -> int: ...
    @property
    def first(self) -> int: ...
    @property
    def length(self) -> int: ...

class WeaveLayer:
    """Threads that cannot be separated without cutting."""

    @property
    def ends(self) -> _Ints: ...
    @property
    def picks(self) -> _Ints: ...
    @property
    def loose(self) -> bool:
        """Whether it is a loose thread: ends or picks alone."""

class LoomUse:
    @property
    def heddles(self) -> _Ints:
        """(shafts,)."""
    @property
    def lifts(self) -> _Ints:
        """(shafts,): picks that name it."""
    @property
    def treadle_uses(self) -> _Ints:
        """(treadles,): picks that use it; empty for a liftplan."""
    @property
    def unthreaded_ends(self) -> int: ...
    @property
    def ends_in_several(self) -> int: ...
    @property
    def empty_picks(self) -> int: ...
    @property
    def most_treadles_per_pick(self) -> int: ...

class Interlacing:
    """Interlacings per crossing, 0 to 1: 1 for plain weave, 0.5 for 2/2 twill."""

    @property
    def warp(self) -> float: ...
    @property
    def weft(self) -> float: ...

class ClothHandle:
    @property
    def kg_per_m2(self) -> float: ...
    @property
    def bending_n_m(self) -> float:
        """Bending stiffness per metre of width, N m."""
    @property
    def bending_length_mm(self) -> float: ...
    @property
    def thickness_mm(self) -> float: ...

class YarnNeed:
    """One yarn in one colour in one system."""

    @property
    def system(self) -> System: ...
    @property
    def yarn(self) -> int: ...
    @property
    def color(self) -> int: ...
    @property
    def threads(self) -> int: ...
    @property
    def length_m(self) -> float: ...
    @property
    def weight_g(self) -> float:
        """With the spare."""

class YarnToBuy:
    """One yarn in one colour, for warp and weft together."""

    @property
    def yarn(self) -> int: ...
    @property
    def color(self) -> int: ...
    @property
    def length_m(self) -> float: ...
    @property
    def weight_g(self) -> float: ...
    @property
    def cones(self) -> int:
        """Whole cones or skeins; 0: bought by weight."""
    @property
    def cost(self) -> float | None:
        """None: the price is unknown."""

class YarnReport:
    @property
    def needs(self) -> tuple[YarnNeed, ...]:
        """Warp first, most threads first."""
    @property
    def buy(self) -> tuple[YarnToBuy, ...]:
        """Heaviest first."""
    @property
    def warp_m(self) -> float: ...
    @property
    def weft_m(self) -> float: ...
    @property
    def weight_g(self) -> float: ...
    @property
    def cost(self) -> float | None:
        """None: a price is unknown."""
    @property
    def g_per_m2(self) -> float:
        """Of the finished cloth, without waste."""

class ClothMeasures:
    """The measures of the planned cloth, on the loom and finished."""

    @property
    def ends(self) -> int: ...
    @property
    def picks(self) -> int:
        """Of all pieces."""
    @property
    def floating(self) -> int:
        """Floating selvedges, beside the ends."""
    @property
    def dents(self) -> int:
        """That the ends fill; 0 without a reed."""
    @property
    def reed_width_mm(self) -> float: ...
    @property
    def woven_width_mm(self) -> float: ...
    @property
    def width_mm(self) -> float:
        """Finished."""
    @property
    def warp_length_mm(self) -> float:
        """As wound, with fringes and loom waste."""
    @property
    def woven_length_mm(self) -> float:
        """Of a piece, on the loom."""
    @property
    def length_mm(self) -> float:
        """Of a piece, finished."""
    @property
    def loom_ends_per_cm(self) -> float: ...
    @property
    def loom_picks_per_cm(self) -> float: ...
    @property
    def cloth_ends_per_cm(self) -> float: ...
    @property
    def cloth_picks_per_cm(self) -> float: ...

class Difference:
    @property
    def what(self) -> str:
        """"threading", "tie-up", "warp colours", "title" ..."""
    @property
    def a(self) -> str: ...
    @property
    def b(self) -> str: ...
    @property
    def threads(self) -> _Ints:
        """Ends, treadles or picks that differ."""

class Comparison:
    @property
    def differences(self) -> tuple[Difference, ...]:
        """Empty: the designs are the same."""
    @property
    def same_cloth(self) -> bool: ...
    @property
    def crossings(self) -> int:
        """That differ, among those that both have."""

def compare(a: Design, b: Design) -> Comparison:
    """What two designs differ in."""

# The cloth

class Maps:
    """One period of a face, sampled on a seamless grid. Row 0 is pick 1, column 0 is end 1: x grows along the weft, y
    along the warp, z out of the face. Arrays are read-only views, of shape (height, width[, channels])."""

    @property
    def width_mm(self) -> float: ...
    @property
    def depth_mm(self) -> float: ...
    @property
    def height_mm(self) -> _Floats:
        """Above the middle plane; gaps have the level of the lowest thread."""
    @property
    def coverage(self) -> _Floats:
        """0 to 1; 0 is a gap."""
    @property
    def color(self) -> _Floats:
        """(height, width, 3), linear: of the thread, not premultiplied."""
    @property
    def groove(self) -> _Floats:
        """0 to 1: factor of the grooves of the twist."""
    @property
    def slope(self) -> _Floats:
        """(height, width, 2): -dz/dx, -dz/dy."""
    @property
    def normal(self) -> _Floats:
        """(height, width, 3), unit length; computed when it is asked for."""
    @property
    def tangent(self) -> _Floats:
        """(height, width, 3), unit length: direction of the fibres, with twist."""
    @property
    def system(self) -> npt.NDArray[np.uint8]:
        """0 warp, 1 weft."""
    @property
    def thread(self) -> npt.NDArray[np.uint32]:
        """Index of the thread in its system, within the period."""
    @property
    def occlusion(self) -> _Floats:
        """0 to 1: visible part of the sky, weighted by the cosine."""
    @property
    def horizon(self) -> npt.NDArray[np.uint8]:
        """(azimuths, height, width): sine of the elevation below which light is blocked, times 255; azimuth k points to
        (cos, sin)(2 pi k / azimuths). A copy."""

# Pictures

class Renderer:
    """Draws many pictures with one context of OpenGL, one at a time, whichever thread calls. By EGL, which needs no
    display. Error of kind 'graphics': there is none."""

    def __init__(self) -> None: ...
    @property
    def device(self) -> str:
        """Graphics card and driver."""
    def render(
        self,
        design: Design,
        width: int = 1280,
        height: int = 800,
        *,
        face: Face = "front",
        yarns_per_pixel: float = 0.0,
        linear: bool = False,
        transparent: bool = False,
        progress: Progress | None = None,
    ) -> npt.NDArray[np.uint8] | _Floats:
        """(height, width, 3): the draped cloth of design.scene, by design.look, row 0 on top; uint8 sRGB, or float32
        scene-linear. `transparent`: no ground and no background, a fourth channel for alpha. `yarns_per_pixel` above 0
        overrides the distance. A design that is drawn again is not woven again."""

def render(
    design: Design,
    width: int = 1280,
    height: int = 800,
    *,
    face: Face = "front",
    yarns_per_pixel: float = 0.0,
    linear: bool = False,
    transparent: bool = False,
    progress: Progress | None = None,
) -> npt.NDArray[np.uint8] | _Floats:
    """One picture, as Renderer().render()."""

def reference(
    design: Design,
    width: int = 1280,
    height: int = 800,
    *,
    spp: int = 64,
    bounces: int = 2,
    face: Face = "front",
    fibres: bool = False,
    progress: Progress | None = None,
) -> _Floats:
    """(height, width, 4), linear, premultiplied by alpha: the cloth of design.scene ray traced, thread by thread or fibre
    by fibre, without ground and background, before exposure. Needs no graphics. `spp`: rays for a pixel; `bounces`: how
    often light goes from thread to thread; with 0, one reflection stands for all (fibres always bounce)."""

def view(design: Design, name: str, width: int = 1280, height: int = 800) -> Scene:
    """The scene of a named view: 'whole', 'head_on', 'grazing', 'near', or one kept with the design."""

def write_image(
    path: Path,
    pixels: npt.NDArray[np.uint8] | npt.NDArray[np.floating] | _Bools,
    depth: Literal["8", "16", "half", "float"] = "8",
) -> None:
    """An array (height, width[, 1 to 4 channels]) as .png, .jpg, .tif or .exr; uint8 of 0 to 255, others of 0 to 1, stored
    as given."""

def export(
    design: Design,
    folder: Path,
    target: str = "gltf",
    *,
    size: int = 1024,
    name: str = "",
    mesh: str = "plane",
    alpha: Literal["auto", "opaque", "mask", "hashed", "blend"] = "auto",
    distance_m: float = 1.0,
    tile_mm: float | None = None,
    mips: Literal["dds", "ktx2", "dds-bc", "ktx2-bc"] | None = None,
    lod: int = 0,
    force: bool = False,
    progress: Progress | None = None,
) -> list[str]:
    """Writes a texture set of one tile, both faces, for one of TARGETS into `folder`, completely or not at all; returns
    remarks. `size`: texels of the longer side, a power of two of 16 to 8,192. `name`: of the files; else the title.
    `tile_mm`: least side of a tile of whole repeats, 0 for one repeat; by default one repeat, or up to 50 mm for yarns with
    slubs, melange or unevenness. `lod`: level of detail, 0 to 2, of the set with these options: 1 has a quarter of the
    size, 2 a sixteenth, and "-lod1" or "-lod2" after the name. `force`: into a folder with other files. Error: it cannot be
    written."""
