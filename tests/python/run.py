"""Runs one suite of unittest: run.py SUITE_test.py. Exits with 77, and says why, where nothing could be tested or a test
was skipped, as the suites in C++ do."""

import importlib
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).parent


def main() -> int:
    try:
        import numpy  # noqa: F401
    except ImportError:
        print("skipped: NumPy is not installed (package python3-numpy)")
        return 77
    sys.path.insert(0, str(HERE))
    suite = unittest.defaultTestLoader.loadTestsFromModule(importlib.import_module(pathlib.Path(sys.argv[1]).stem))
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    if not result.wasSuccessful() or result.testsRun == 0:
        return 1
    return 77 if result.skipped else 0


sys.exit(main())
