"""What the keywords of the procedural twins may be: settings_stub.py package-folder > _settings.pyi.

A twin ``SurfaceDRR(mesh, geometry, **settings)`` hands each further keyword to the ``Set...`` of its class. Here these are written
down as one TypedDict a twin, from the stub of the compiled part and from the sources of the package, so that a type checker knows a
misspelt keyword and a value of the wrong kind. Keywords that the twin names itself are left out of them.
"""
from __future__ import annotations

import ast
import pathlib
import re
import sys

HEADER = '''"""
Further keywords of the procedural twins; made by Wrapping/Python/settings_stub.py.
"""
'''


def bases(node: ast.ClassDef) -> list[str]:
    return [ast.unparse(base).split(".")[-1] for base in node.bases]


class QualifyCompiledNames(ast.NodeTransformer):
    """``Jaw | str`` of the compiled part's stub as ``_core.Jaw | str``."""

    def __init__(self, names: set[str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.AST:
        if node.id not in self.names:
            return node
        return ast.Attribute(ast.Name("_core", ast.Load()), node.id, ast.Load())


class Package:
    def __init__(self, folder: pathlib.Path) -> None:
        #: By source: classes, and where each name of another module comes from.
        self.classes: dict[str, dict[str, ast.ClassDef]] = {}
        self.imports: dict[str, str] = {}
        self.twins: list[ast.FunctionDef] = []
        self.functions: list[ast.stmt] = []
        for file in [folder / "_core.pyi", *sorted(folder.glob("_*.py"))]:
            tree = ast.parse(file.read_text())
            self.classes[file.stem] = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
            for node in tree.body:
                if isinstance(node, ast.ImportFrom) and file.stem != "_core":
                    for alias in node.names:
                        self.imports[alias.name] = "." * node.level + (node.module or "")
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and file.stem != "_core":
                    self.functions.append(node)
                if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                    settings = node.args.kwarg
                    if settings and settings.annotation and "Settings]" in ast.unparse(settings.annotation):
                        self.twins.append(node)
        self.own = {name: node for source, group in self.classes.items() if source != "_core" for name, node in group.items()}
        self.qualify = QualifyCompiledNames(set(self.classes["_core"]))

    def setters(self, name: str, compiled: bool) -> dict[str, str]:
        """Setting to type: of a class with its bases, the nearest first."""
        node = self.classes["_core"].get(name) if compiled else self.own.get(name)
        if node is None:
            return {}
        found: dict[str, str] = {}
        for member in node.body:
            if not isinstance(member, ast.FunctionDef) or not member.name.startswith("Set"):
                continue
            arguments = member.args.args[1:]
            needed = len(arguments) - len(member.args.defaults)
            if member.decorator_list or not arguments or needed > 1 or member.args.vararg or member.args.kwonlyargs:
                continue
            annotation = arguments[0].annotation
            assert annotation is not None, f"{name}.{member.name}"
            kind = self.qualify.visit(annotation) if compiled else annotation
            # SetOptimizerAsPowell() and the like are a choice with settings of its own, no value.
            if re.match(r"Set(Optimizer|Metric)As[A-Z]", member.name):
                continue
            found[member.name[3:4].lower() + member.name[4:]] = ast.unparse(kind)
        for base, spelt in zip(node.bases, bases(node)):
            inherited = self.setters(spelt, compiled or ast.unparse(base).startswith("_core."))
            found = {**inherited, **found}
        return found

    def arguments(self, path: str) -> dict[str, str]:
        """Argument to type: of a function, or of a method by Class.Method."""
        scope: list[ast.stmt] = self.functions
        for name in path.split("."):
            node = next(each for each in scope if isinstance(each, (ast.ClassDef, ast.FunctionDef)) and each.name == name)
            scope = node.body
        assert isinstance(node, ast.FunctionDef)
        given = [argument for argument in [*node.args.args, *node.args.kwonlyargs] if argument.arg != "self"]
        return {argument.arg: ast.unparse(argument.annotation) for argument in given if argument.annotation}

    def process(self, twin: ast.FunctionDef) -> str:
        """The class whose Set... are called: the one that the twin's body makes."""
        for node in ast.walk(twin):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in self.own:
                if self.setters(node.func.id, False):
                    return node.func.id
        return MADE_ELSEWHERE[twin.name]


#: Twins whose body makes no process object: of two readers, whose settings are the same, a function chooses.
MADE_ELSEWHERE = {"ReadLandmarks": "DentalLandmarkFileReader2D"}
#: Those that hand their keywords to a function, of which these are the arguments.
HANDED_ON = {
    "batch": "register", "FindLandmarkCounterparts": "LandmarkCounterpartFilter.Execute", "FindToothCrowns": "ToothCrownFilter.Execute",
}
#: Arguments that a twin gives by itself.
GIVEN = {"batch": {"case"}}


def main() -> None:
    package = Package(pathlib.Path(sys.argv[1]))
    kinds = []
    for twin in sorted(package.twins, key=lambda node: node.name):
        named = {argument.arg for argument in [*twin.args.args, *twin.args.kwonlyargs]} | GIVEN.get(twin.name, set())
        handed = HANDED_ON.get(twin.name)
        taken = package.arguments(handed) if handed else package.setters(package.process(twin), False)
        lines = [f"    {name}: {kind}" for name, kind in sorted(taken.items()) if name not in named]
        assert lines, f"{twin.name} has no further keywords"
        kinds.append("\n".join([f"class {twin.name[0].upper()}{twin.name[1:]}Settings(TypedDict, total=False):", *lines]))
    text = "\n\n".join(kinds) + "\n"
    used = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
    sources: dict[str, list[str]] = {"typing": ["TypedDict"]}
    for name in sorted(used & set(package.imports) - {"_core", "TypedDict"}):
        sources.setdefault(package.imports[name], []).append(name)
    lines = ["import numpy.typing", "import typing"] if "numpy" in used else ["import typing"]
    lines += [f"from {source} import {', '.join(sorted(names))}" for source, names in sorted(sources.items(), key=lambda i: i[0] != "typing")]
    sys.stdout.write(HEADER + "\n".join(lines) + "\nfrom . import _core\n\n" + text)


main()
