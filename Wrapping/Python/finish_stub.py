"""What pybind11-stubgen can't know of the compiled part: finish_stub.py _core.pyi > finished.

Parameters take more than the values that come back: any array, any sequence, the name of an enumeration's value, None
where an input is taken away.
"""
import re
import sys

text = open(sys.argv[1]).read()
ENUMERATIONS = re.findall(r"^(?: {4})?class (\w+):(?:(?!^(?: {4})?class ).)*?__members__", text, re.M | re.S)
DATA = (
    "Mesh", "Image", "Contour", "CephalometricGeometry", "Similarity2DTransform", "VersorRigid3DTransform",
    "ContourToContourMetricv4", "RobustKernel", "ResidualNoiseModel", "PoseSolution",
)
# Outputs that need not be there.
OPTIONAL_OUTPUTS = ("_GetMesh", "_GetContour", "_GetImage", "_GetRadiograph", "_GetTransform")


def parameter(function: str, kind: str) -> str:
    if kind == "numpy.ndarray":
        return "numpy.typing.ArrayLike"
    kind = re.sub(r"tuple\[(float|int)(?:, \1)*\]", r"typing.Sequence[\1]", kind)
    kind = re.sub(r"\blist\[", "typing.Sequence[", kind)
    kind = re.sub(r"\bdict\[", "typing.Mapping[", kind)
    if kind.split(".")[-1] in ENUMERATIONS:
        return f"{kind} | str"
    takes_none = re.match(
        r"_Set|_AddView$|SetMetric$|_Case\.__init__|CephalometricPoseTransform\.__init__|PoseRegistrationMethod\.(_?Set|_AddView)", function
    )
    return f"{kind} | None" if takes_none and kind in DATA else kind


def finish(match: re.Match) -> str:
    indent, name, arguments, result = match.groups()
    function = f"{owner}.{name}" if name == "__init__" or owner == "PoseRegistrationMethod" else name
    parts, depth, start = [], 0, 0
    for i, character in enumerate(arguments + ","):
        depth += (character in "[(") - (character in "])")
        if character == "," and depth == 0:
            parts.append(arguments[start:i].strip())
            start = i + 1
    finished = []
    for part in parts:
        typed = re.match(r"(\w+): (.*?)( = .*)?$", part)
        if typed:
            part = f"{typed.group(1)}: {parameter(function, typed.group(2))}{typed.group(3) or ''}"
        finished.append(part)
    if name in OPTIONAL_OUTPUTS and result in DATA and not owner.endswith("Method"):
        result += " | None"
    return f"{indent}def {name}({', '.join(part for part in finished if part)}) -> {result}:"


lines = []
owner = ""
for line in text.splitlines():
    klass = re.match(r"class (\w+)", line)
    if klass:
        owner = klass.group(1)
    line = re.sub(r"^( *)def (\w+)\((.*)\) -> (.*):$", finish, line)
    lines.append(line.rstrip())
text = "\n".join(lines) + "\n"
text = re.sub(r"\bnumpy\.ndarray\b", "numpy.typing.NDArray[typing.Any]", text)
text = re.sub(r"(->|:) dict\b(?!\[)", r"\1 dict[str, typing.Any]", text)
text = re.sub(r"(->|:) tuple\b(?!\[)", r"\1 tuple[typing.Any, ...]", text)
text = re.sub(r"(->|:) list\b(?!\[)", r"\1 list[typing.Any]", text)
text = re.sub(r"\b(float|int)\[\d+\]", r"\1", text)
text = re.sub(r"(:) typing\.Callable\b(?!\[)", r"\1 typing.Callable[..., typing.Any]", text)
text = re.sub(r"def __eq__\(self, \w+: \w+\)", "def __eq__(self, other: object)", text)
text = re.sub(r"(__hash__: typing\.ClassVar\[None\] = None)", r"\1  # type: ignore[assignment]", text)
text = text.replace("import numpy\n", "import numpy\nimport numpy.typing\n", 1)
if "__version__" not in text:
    text = text.rstrip() + "\n__version__: str\n"
sys.stdout.write(text)
