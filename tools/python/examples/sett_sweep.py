"""One draft at several setts: how open the cloth is, what it weighs, how stiff it is and how much light it reflects.

python3 sett_sweep.py DRAFT.wif [--setts 8,10,12,14] [-o sweep.csv]
"""

import argparse
import csv
import sys

import weftlight

COLUMNS = ("threads_per_cm", "cover", "g_per_m2", "bending_n_m", "reflectance")


def at_sett(design: weftlight.Design, threads_per_cm: float) -> weftlight.Design:
    """The draft with that many ends and picks in a centimetre."""
    spacing = 10 / threads_per_cm
    return design.with_thread_spacing("warp", range(design.ends), spacing).with_thread_spacing(
        "weft", range(design.picks), spacing
    )


def measured(design: weftlight.Design, threads_per_cm: float) -> dict[str, float]:
    cloth = at_sett(design, threads_per_cm)
    handle = cloth.handle()
    # Radiance straight back under light from straight above, times pi: 1 for a white Lambertian surface.
    reflectance = float(cloth.response([0], [0]).mean() * 3.14159265)
    cover = float(cloth.maps((256, 256)).coverage.mean())
    numbers = (threads_per_cm, cover, 1000 * handle.kg_per_m2, handle.bending_n_m, reflectance)
    return dict(zip(COLUMNS, numbers))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("draft")
    parser.add_argument("--setts", default="6,8,10,12,14,16,18,20")
    parser.add_argument("-o", "--out", default="-")
    given = parser.parse_args()
    try:
        design = weftlight.read(given.draft).design
    except weftlight.Error as error:
        print(error, file=sys.stderr)
        return 1
    with sys.stdout if given.out == "-" else open(given.out, "w", newline="") as out:
        table = csv.DictWriter(out, COLUMNS)
        table.writeheader()
        for sett in given.setts.split(","):
            table.writerow({name: f"{value:.4g}" for name, value in measured(design, float(sett)).items()})
    return 0


if __name__ == "__main__":
    sys.exit(main())
