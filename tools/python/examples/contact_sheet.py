"""A hundred drafts on one sheet: the beginning of each cloth, lit from the upper left.

python3 contact_sheet.py FOLDER -o sheet.png [--count 100] [--cell 160] [--threads 40]
"""

import argparse
import pathlib
import sys

import numpy as np
import numpy.typing as npt

import weftlight

Picture = npt.NDArray[np.uint8]

TOWARDS_LIGHT = np.array([0.5, -0.5, 0.7], np.float32)  # end 1 is at the right: x grows to the left, y downwards


def swatch(design: weftlight.Design, side: int, threads: int) -> Picture:
    """As many ends and picks, as cloth: the maps, shaded. For light that is true to the yarns see weftlight.Renderer."""
    part = design.with_size(ends=min(design.ends, threads), picks=min(design.picks, threads))
    maps = part.maps((side, side), period="draft", azimuths=8)
    lit = np.clip(maps.normal @ (TOWARDS_LIGHT / np.linalg.norm(TOWARDS_LIGHT)), 0, 1)
    linear = maps.color * (maps.coverage * maps.groove * (0.3 * maps.occlusion + lit))[..., None]
    linear += (1 - maps.coverage)[..., None]
    picture: Picture = (255 * np.clip(linear[:, ::-1], 0, 1) ** (1 / 2.2) + 0.5).astype(np.uint8)
    return picture


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("-o", "--out", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--cell", type=int, default=160)
    parser.add_argument("--threads", type=int, default=40)
    given = parser.parse_args()
    pictures = []
    drafts = sorted(p for p in given.folder.rglob("*") if p.suffix.lower() in (".wif", ".dtx", ".wpo"))
    for path in drafts[: given.count]:
        try:
            pictures.append(swatch(weftlight.read(path).design, given.cell, given.threads))
        except weftlight.Error as error:
            print(error, file=sys.stderr)
    if not pictures:
        print(f"{given.folder}: there is no draft in it", file=sys.stderr)
        return 1
    columns = int(np.ceil(np.sqrt(len(pictures))))
    rows = int(np.ceil(len(pictures) / columns))
    gap = 4
    sheet = np.full((rows * (given.cell + gap) + gap, columns * (given.cell + gap) + gap, 3), 255, np.uint8)
    for i, picture in enumerate(pictures):
        y, x = (gap + k * (given.cell + gap) for k in divmod(i, columns))
        sheet[y : y + given.cell, x : x + given.cell] = picture
    weftlight.write_image(given.out, sheet)
    print(f"{len(pictures)} drafts on {given.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
