"""Shared by the suites: the source folder, drafts, and where it is noted that nothing could be drawn."""

import os
import pathlib
import unittest

import numpy as np

import weftlight as wl

SOURCE = pathlib.Path(os.environ["WEFTLIGHT_SOURCE"])
FIXTURES = SOURCE / "tests" / "fixtures"


def twill() -> wl.Design:
    """2/2 twill by hand: a straight draw of eight ends on four shafts, six picks."""
    draw = np.eye(4, dtype=bool)
    tieup = np.array([[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 1], [1, 0, 0, 1]], dtype=bool)
    return wl.Design(threading=np.tile(draw, (2, 1)), tieup=tieup, treadling=np.tile(draw, (2, 1))[:6])


def renderer(test: unittest.TestCase) -> wl.Renderer:
    """A renderer, or the test is skipped and tests/house/drawing.sh told."""
    folder = os.environ.get("WEFTLIGHT_NOT_DRAWN")
    record = pathlib.Path(folder) / f"python.{type(test).__name__}" if folder else None
    if record:
        record.unlink(missing_ok=True)
    try:
        return wl.Renderer()
    except wl.Error as error:
        if error.kind != "graphics":
            raise
        if record:
            record.parent.mkdir(parents=True, exist_ok=True)
            record.write_text(f"{error}\n")
        test.skipTest(f"no graphics: {error}")
