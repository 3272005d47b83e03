"""The types: __init__.pyi and the module have the same names and arguments, and a checker accepts both."""

import ast
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import weftlight as wl
from common import SOURCE

STUB = SOURCE / "tools" / "python" / "weftlight" / "__init__.pyi"


def public(name):
    return not name.startswith("_") or name in ("__init__",)


def arguments_of_stub(node):
    """['a', 'b=', '*', 'c='] of a definition."""
    a = node.args
    plain = [x.arg for x in a.posonlyargs + a.args]
    filled = len(plain) - len(a.defaults)
    out = [name + ("=" if i >= filled else "") for i, name in enumerate(plain)]
    if a.kwonlyargs:
        out.append("*")
    out += [x.arg + ("=" if d is not None else "") for x, d in zip(a.kwonlyargs, a.kw_defaults)]
    return out + (["**"] if a.kwarg else [])


def arguments_of_module(function):
    """The same of the first line of pybind11's docstring: name(a: T, b: T = x, *, c: T, **kwargs) -> T."""
    inside = re.match(r"\w+\((.*)\) -> ", function.__doc__.strip().splitlines()[0]).group(1)
    parts, depth, quoted = [""], 0, False
    for c in inside:
        quoted ^= c == "'"
        depth += (c in "([{<") - (c in ")]}>")
        if c == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += c
    out = []
    for part in filter(None, (p.strip() for p in parts)):
        if part.startswith("**"):
            out.append("**")
        elif part == "*":
            out.append("*")
        else:
            out.append(part.split(":")[0].strip() + ("=" if " = " in part else ""))
    return out


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = ast.parse(STUB.read_text())

    def check_function(self, node, function, where):
        stub, module = arguments_of_stub(node), arguments_of_module(function)
        if stub and stub[0] == "self":
            module[0] = "self"
        self.assertEqual(stub, module, where)

    def test_names_of_the_module(self):
        stub = set()
        for node in self.tree.body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                stub.add(node.name)
            elif isinstance(node, ast.AnnAssign):
                stub.add(node.target.id)
        stub.discard("__version__")
        self.assertEqual(stub, {n for n in dir(wl) if public(n)} - {"__init__"})

    def test_functions(self):
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef):
                self.check_function(node, getattr(wl, node.name), node.name)

    def test_classes(self):
        for node in self.tree.body:
            if not isinstance(node, ast.ClassDef):
                continue
            cls = getattr(wl, node.name)
            self.assertEqual(cls.__module__, "weftlight")
            if issubclass(cls, Exception):
                continue
            members = {m.name: m for m in node.body if isinstance(m, ast.FunctionDef)}
            self.assertEqual({m for m in members if public(m)} - {"__init__"},
                             {m for m in dir(cls) if public(m)} - {"__init__"}, node.name)
            for name, member in members.items():
                is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in member.decorator_list)
                where = f"{node.name}.{name}"
                self.assertEqual(is_property, isinstance(getattr(cls, name), property), where)
                if not is_property and name not in ("__eq__", "__len__"):
                    self.check_function(member, getattr(cls, name), where)

    def test_every_name_is_explained(self):
        for name in dir(wl):
            thing = getattr(wl, name)
            if public(name) and callable(thing):
                self.assertTrue((thing.__doc__ or "").strip(), name)

    def test_stubtest(self):
        tool = shutil.which("stubtest", path="/usr/bin") or shutil.which("stubtest")
        if not tool:
            self.skipTest("stubtest is not installed (package mypy)")
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as allowed:
            # The extension has no stub of its own: the package re-exports all of it. pybind11's classes have a metaclass
            # and an __init__ that no user sees; names and arguments are compared above.
            allowed.write("weftlight._weftlight\nweftlight\\.[A-Z]\\w*\nweftlight\\.[A-Z]\\w*\\.__init__\n")
            allowed.flush()
            run = subprocess.run([tool, "weftlight", "--allowlist", allowed.name, "--ignore-unused-allowlist"],
                                 capture_output=True, text=True, cwd=tempfile.gettempdir())
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_a_checker_accepts_a_user(self):
        tool = shutil.which("mypy", path="/usr/bin") or shutil.which("mypy")
        if not tool:
            self.skipTest("mypy is not installed (package mypy)")
        examples = sorted(str(p) for p in (SOURCE / "tools" / "python" / "examples").glob("*.py"))
        with tempfile.TemporaryDirectory() as cache:
            run = subprocess.run([tool, "--strict", "--cache-dir", cache, *examples], capture_output=True, text=True,
                                 cwd=tempfile.gettempdir())
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main())
