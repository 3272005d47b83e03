"""Weaving drafts and the cloth they make: see __init__.pyi for every name, docs/python.md for a manual."""

from ._weftlight import *  # noqa: F401,F403
from ._weftlight import __version__  # noqa: F401
